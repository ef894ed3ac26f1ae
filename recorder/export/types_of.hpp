#pragma once
// The types that a recording's channels were recorded with, each IDL text read once.

#include "recorder/recording/idl_schema.hpp"
#include "recorder/recording/recording.hpp"

namespace windlass::recorder {

class TypesOf {
public:
    explicit TypesOf(const recording::Recording& recording) : recording_(recording) {}

    /// Nothing when the recording does not say, or says what is not understood (told once on stderr).
    const recording::Type* find(const mcap::Channel& channel);

private:
    const recording::Recording& recording_;
    std::map<std::string, std::unique_ptr<recording::IdlSchema>> schemas_; // by text; empty: not understood
    std::map<const mcap::Channel*, const recording::Type*> types_;
};

} // namespace windlass::recorder
