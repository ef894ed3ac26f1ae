#include "idl/idl_tokens.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace windlass::idl {

namespace {

bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

std::size_t word_end(std::string_view text, std::size_t at) {
    while (at < text.size() && in_word(text[at]))
        ++at;
    return at;
}

} // namespace

std::vector<IdlToken> idl_tokens(std::string_view text) {
    std::vector<IdlToken> tokens;
    int line = 1;
    bool key = false;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        const std::string_view rest = text.substr(at);
        std::size_t length = 1;
        if (c == '\n') {
            ++line;
        } else if (rest.starts_with("//")) {
            length = std::min(rest.find('\n'), rest.size());
            const auto begin = rest.substr(0, length).find_first_not_of("/ ");
            if (begin < length && !tokens.empty() && tokens.back().line == line)
                tokens.back().comment = rest.substr(begin, length - begin);
        } else if (rest.starts_with("/*")) {
            length = std::min(rest.find("*/"), rest.size() - 2) + 2;
            line +=
                static_cast<int>(std::count(rest.begin(), rest.begin() + static_cast<long>(length), '\n'));
        } else if (c == '#') { // a line for the preprocessor
            length = std::min(rest.find('\n'), rest.size());
        } else if (c == '@') {
            length = word_end(rest, 1);
            if (length < rest.size() && rest[length] == '(')
                length = std::min(rest.find(')'), rest.size() - 1) + 1;
            key = rest.substr(0, length) == "@key";
        } else if (in_word(c)) {
            length = word_end(rest, 0);
            tokens.push_back({std::string(rest.substr(0, length)), "", line, std::exchange(key, false)});
        } else if (rest.starts_with("::")) {
            length = 2;
            tokens.push_back({"::", "", line, false});
        } else if (std::isspace(static_cast<unsigned char>(c)) == 0) {
            tokens.push_back({std::string(1, c), "", line, false});
        }
        at += length;
    }
    tokens.push_back({"", "", line, false});
    return tokens;
}

} // namespace windlass::idl
