#include "recorder/export/types_of.hpp"

#include "recorder/command.hpp"

namespace windlass::recorder {

const idl::Type* TypesOf::find(const mcap::Channel& channel) {
    if (const auto known = types_.find(&channel); known != types_.end()) return known->second;
    const auto [name, text] = recording_.type_of(channel);
    auto& schema = schemas_[text];
    try {
        if (!schema) schema = std::make_unique<idl::IdlSchema>(text);
    } catch (const idl::IdlError& error) {
        tell(channel.topic + ": " + error.what());
    }
    const auto* type = schema ? schema->find(name) : nullptr;
    if (type == nullptr) tell(channel.topic + ": its type is not known, and it is left out");
    return types_[&channel] = type;
}

} // namespace windlass::recorder
