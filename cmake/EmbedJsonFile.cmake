# One JSON file as one header; called by windlass_embed_json while building.
file(READ "${FILE}" text)
file(WRITE "${HEADER}" "#pragma once
// Made from ${FILE}
#include <string_view>

namespace windlass::embedded {
inline constexpr std::string_view ${NAME} = R\"~~~(${text})~~~\";
}
")
