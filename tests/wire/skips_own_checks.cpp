// A client that skips its own checks: preloaded into a program, it lets the program make writers and readers
// that its permissions forbid. What keeps it out then is only what the others check.

#include <cstdint>

#define ACCESS "_ZN8eprosima8fastrtps4rtps8security11Permissions"
#define HANDLE "ERKNS2_6HandleEj"
#define TOPIC                                                                                                \
    "RKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKSt6vectorISC_SaISC_EERNS2_17SecurityExceptionE"

using Any = const void*; // references, none of which is looked at

bool may_create_writer(Any, Any, std::uint32_t, Any, Any,
                       Any) asm(ACCESS "23check_create_datawriter" HANDLE TOPIC);
bool may_create_reader(Any, Any, std::uint32_t, Any, Any,
                       Any) asm(ACCESS "23check_create_datareader" HANDLE TOPIC);
bool may_write_to(Any, Any, std::uint32_t, Any, bool* relay_only,
                  Any) asm(ACCESS "23check_remote_datareader" HANDLE
                                  "RKNS1_15ReaderProxyDataERbRNS2_17SecurityExceptionE");
bool may_read_from(Any, Any, std::uint32_t, Any,
                   Any) asm(ACCESS "23check_remote_datawriter" HANDLE
                                   "RKNS1_15WriterProxyDataERNS2_17SecurityExceptionE");

bool may_create_writer(Any, Any, std::uint32_t, Any, Any, Any) {
    return true;
}
bool may_create_reader(Any, Any, std::uint32_t, Any, Any, Any) {
    return true;
}
bool may_write_to(Any, Any, std::uint32_t, Any, bool* relay_only, Any) {
    *relay_only = false;
    return true;
}
bool may_read_from(Any, Any, std::uint32_t, Any, Any) {
    return true;
}
