#include "idl/idl_text.hpp"

#include "embedded/windlass_idl.hpp"

namespace windlass::idl {

std::string_view own_text() {
    return embedded::windlass_idl;
}

const IdlSchema& own_schema() {
    static const IdlSchema schema(own_text());
    return schema;
}

} // namespace windlass::idl
