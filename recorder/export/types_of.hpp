#pragma once
// The types that a recording's channels were recorded with, each IDL text read once.

#include "idl/idl_schema.hpp"
#include "recorder/recording/recording.hpp"

namespace windlass::recorder {

class TypesOf {
public:
    explicit TypesOf(const recording::Recording& recording) : recording_(recording) {}

    /// Nothing when the recording does not say, or says what is not understood (told once on stderr).
    const idl::Type* find(const mcap::Channel& channel);

private:
    const recording::Recording& recording_;
    std::map<std::string, std::unique_ptr<idl::IdlSchema>> schemas_; // by text; empty: not understood
    std::map<const mcap::Channel*, const idl::Type*> types_;
};

} // namespace windlass::recorder
