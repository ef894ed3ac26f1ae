#!/bin/sh
# loops_call_nothing.sh LIBRARY: of the functions that are compiled for wide vectors (WINDLASS_WIDE) none calls ours
# in its loops, by which a loop would be no vectors any more and a step of the chain take twice its time. Reads the
# relocations of the static library's calls.
set -eu
objdump --disassemble --reloc --demangle --no-show-raw-insn "$1" | awk '
    /^[0-9a-f]+ <.*>:$/ {
        wide = /\[clone \.avx512f\]/ || (/move_in_water</ && !/\.resolver/)
        function_name = $0
        if (wide) found[/move_in_water</ ? "move_in_water" : "other"]++
    }
    # Once a step, behind the loop: links that lie round an edge have rows of their own.
    wide && /R_X86_64_(PLT32|PC32|GOTPCREL).*windlass::/ && /call|PLT32/ && !/set_up_wrapped/ {
        print substr(function_name, 1, 110) "\n    calls" substr($0, index($0, "windlass::") - 1, 90)
        calls++
    }
    END {
        if (found["move_in_water"] < 3 || found["other"] < 5) {
            print "not the library that was meant: " found["move_in_water"] + 0 " and " found["other"] + 0 " wide loops in it"
            exit 2
        }
        exit calls > 0
    }'
