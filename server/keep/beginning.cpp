#include "server/keep/beginning.hpp"

#include "idl/cdr.hpp"

namespace windlass::keep {

std::vector<std::uint8_t> encode(const Beginning& beginning) {
    idl::CdrWriter out;
    out.text(beginning.orders);
    out.number(beginning.format);
    out.text(beginning.id);
    out.number(beginning.definition_hash);
    out.number(beginning.course.first);
    out.number(beginning.course.settled);
    return out.release();
}

Beginning decode_beginning(files::Bytes payload) {
    idl::CdrReader in(payload);
    Beginning beginning;
    beginning.orders = in.text();
    beginning.format = in.number<std::uint32_t>();
    beginning.id = in.text();
    beginning.definition_hash = in.number<std::uint64_t>();
    beginning.course.first = in.number<std::uint64_t>();
    beginning.course.settled = in.number<std::uint64_t>();
    return beginning;
}

} // namespace windlass::keep
