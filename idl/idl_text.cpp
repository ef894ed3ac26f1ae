#include "idl/idl_text.hpp"

#include "embedded/windlass_idl.hpp"
#include "idl/topics.hpp"

namespace windlass::idl {

std::string_view own_text() {
    return embedded::windlass_idl;
}

const IdlSchema& own_schema() {
    static const IdlSchema schema(own_text());
    return schema;
}

#define WINDLASS_OWN_TYPE(T)                                                                                 \
    template <>                                                                                              \
    const Type& own_type<T>() {                                                                              \
        static const Type& type = *own_schema().find(wire::type_name(#T));                                   \
        return type;                                                                                         \
    }
WINDLASS_TOPIC_TYPES(WINDLASS_OWN_TYPE)
#undef WINDLASS_OWN_TYPE

} // namespace windlass::idl
