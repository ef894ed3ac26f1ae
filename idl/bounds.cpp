#include "idl/bounds.hpp"

#include "idl/cdr_walk.hpp"
#include "idl/idl_text.hpp"
#include "idl/topic_types.hpp"
#include "idl/types.hpp"

namespace windlass::wire {

bool claims_within_bounds(const idl::Type& type, Bytes payload) {
    if (!type.has_sequence) return true;
    try {
        walk_lengths(type, payload);
        return true;
    } catch (const idl::PayloadError&) {
        return false;
    }
}

#define WINDLASS_CLAIMS_OF_TYPE(T)                                                                           \
    template <>                                                                                              \
    bool claims_within_bounds<T>(Bytes payload) {                                                            \
        return claims_within_bounds(idl::own_type<T>(), payload);                                            \
    }
WINDLASS_TOPIC_TYPES(WINDLASS_CLAIMS_OF_TYPE)
#undef WINDLASS_CLAIMS_OF_TYPE

} // namespace windlass::wire
