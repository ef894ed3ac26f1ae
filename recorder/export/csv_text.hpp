#pragma once
// A payload as a line of CSV (RFC 4180). Structures are spread over columns "position.x (m)"; a sequence is
// one cell: numbers "1 2 3", structures of numbers "1 2 3;4 5 6", others as JSON. Octets: how many.

#include "idl/cdr.hpp"

namespace windlass::recorder {

/// Names of the columns, with units in brackets where the IDL gives them.
std::vector<std::string> csv_columns(const idl::Type& type);

/// Appends the payload's cells, each with a comma before it. Throws mcap::Damage.
void append_csv(const idl::Type& type, idl::Bytes payload, std::string& out);

/// The cell as it stands in the file: in quotes where it has to be.
std::string csv_cell(std::string_view text);

} // namespace windlass::recorder
