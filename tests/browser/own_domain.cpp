// Runs a command in a DDS domain that no other test on this machine has at the same time: for tests that
// are no C++.
//
// usage: own_domain COMMAND [ARGUMENT...]      the command finds the domain in $WINDLASS_DOMAIN

#include "rigs/own_domain.hpp"

#include <cstdlib>
#include <string>

int main(int count, char** arguments) {
    if (count < 2) {
        std::fprintf(stderr, "usage: own_domain COMMAND [ARGUMENT...]\n");
        return 2;
    }
    // The command and what it starts inherit the socket that holds the domain.
    setenv("WINDLASS_DOMAIN", std::to_string(windlass::rigs::own_domain()).c_str(), 1);
    execvp(arguments[1], arguments + 1);
    std::perror(arguments[1]);
    return 127;
}
