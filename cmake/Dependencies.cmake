# Every library that we build on, found once. The Debian packages stand in packages.txt.

find_package(PkgConfig REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(spdlog REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(valijson REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fastcdr REQUIRED)
find_package(fastrtps 2.9 REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)
find_package(Threads REQUIRED)
find_package(Boost 1.74 REQUIRED) # Beast, of which headers do
find_package(OpenSSL REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)
pkg_check_modules(SQLITE3 REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(SODIUM REQUIRED IMPORTED_TARGET libsodium)
find_program(FASTDDSGEN fastddsgen REQUIRED)


# Bullet in double precision: Debian has it as bullet-float64 beside the single-precision one. Only
# dynamics and collision are linked.
pkg_check_modules(BULLET REQUIRED bullet-float64)
add_library(bullet_float64 INTERFACE)
add_library(windlass::bullet ALIAS bullet_float64)
target_include_directories(bullet_float64 SYSTEM INTERFACE ${BULLET_INCLUDE_DIRS})
target_compile_definitions(bullet_float64 INTERFACE BT_USE_DOUBLE_PRECISION)
target_link_libraries(bullet_float64 INTERFACE BulletDynamics-float64 BulletCollision-float64 LinearMath-float64)
