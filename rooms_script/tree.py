"""What is done once in the whole tree: CMake, layers, documents, one function that goes to another room."""
import os, re

def edit(path, *changes):
    if not os.path.isfile(path): return
    text = old = open(path, encoding='utf-8').read()
    for before, after in changes:
        if isinstance(before, re.Pattern): text = before.sub(after, text)
        elif not after or after not in text: text = text.replace(before, after)
    if text != old: open(path, 'w', encoding='utf-8').write(text)

def report_text():
    """From what is seen to what is said."""
    views = 'server/exercise/picture/views.cpp'
    text = open(views, encoding='utf-8').read()
    function = re.search(r'^std::string report_text\(.*?^\}\n\n', text, re.S | re.M)
    helper = re.search(r'^std::string figure\(.*?^\}\n\n', text, re.S | re.M)
    if not function: return
    rest = text.replace(function[0], '')
    if helper: rest = rest.replace(helper[0], '')
    rest = rest.replace('#include "server/exercise/talk/bridge_orders.hpp"\n', '')
    for include, needs in (('<cstdio>', 'printf'), ('<array>', 'std::array')):
        if needs not in rest: rest = rest.replace(f'#include {include}\n', '')
    open(views, 'w', encoding='utf-8').write(rest)
    header = 'server/exercise/picture/views.hpp'
    text = open(header, encoding='utf-8').read()
    said = re.search(r'^/// One line for the log[^\n]*\n(?:///[^\n]*\n)*std::string report_text\([^;]*;\n\n', text, re.M)
    open(header, 'w', encoding='utf-8').write(text.replace(said[0], ''))
    open('server/exercise/talk/report_text.hpp', 'w', encoding='utf-8').write(
        '#pragma once\n// A report of the forecastle as the log has it.\n\n'
        '#include "server/exercise/definition/orders.hpp"\n\n#include <string>\n\n'
        'namespace windlass::exercise {\n\n' + said[0] + '} // namespace windlass::exercise\n')
    used = function[0] + (helper[0] if helper else '')
    includes = ''.join(f'#include {i}\n' for i, n in (('<array>', 'std::array'), ('<cstdio>', 'printf')) if n in used)
    open('server/exercise/talk/report_text.cpp', 'w', encoding='utf-8').write(
        '#include "server/exercise/talk/report_text.hpp"\n\n#include "server/exercise/talk/bridge_orders.hpp"\n\n' + includes +
        '\nnamespace windlass::exercise {\n\n' + ('namespace {\n\n' + helper[0] + '} // namespace\n\n' if helper else '') +
        function[0] + '} // namespace windlass::exercise\n')
    edit('server/exercise/CMakeLists.txt', ('  talk/talk.cpp\n', '  talk/report_text.cpp\n  talk/talk.cpp\n'))
    edit('server/exercise/exercise.cpp', ('#include "server/exercise/talk/talk.hpp"\n',
         '#include "server/exercise/talk/report_text.hpp"\n#include "server/exercise/talk/talk.hpp"\n'))

TABLE = """
| room of `server/exercise` | what lives there |
|---|---|
| `weather/` | wind, waves, stream, light and their ramp; the tide's table |
| `definition/` | an exercise as data, with its faults; every order that it may be given |
| `picture/` | what is seen of it from outside after a tick, and how that is copied from the physics |
| `faults/` | the table of faults and the book that arms, triggers and clears them |
| `talk/` | orders of the bridge, reports of the forecastle, what gets through; lights and shapes |
| `watch/` | what is called out: events of the cable, brought up and dragging, the watch circle, aground, the model in doubt |
| `tick/` | the deck: each side's tackle, levers and eyes in one tick |
| `exercise.cpp` beside them | the step itself; prelude, checkpoint, hash of the state |

Namespaces follow rooms: `windlass::physics` and `windlass::exercise` with the rooms below them, `windlass::config`, `::run`, `::dds`, `::host` and so on; what is common is in `windlass` itself.
"""

def whole_tree():
    report_text()
    path = 'server/exercise/CMakeLists.txt'
    text = open(path).read()
    sources = re.search(r'add_library\(windlass_exercise STATIC\n((?:  \S+\.cpp\n)+  \S+\.cpp)\)', text)
    lines = sorted(sources[1].split('\n'), key=lambda l: ('/' in l, l))
    open(path, 'w').write(text.replace(sources[1], '\n'.join(lines)))
    edit('tests/layers/layers_test.cpp',
         (re.compile(r' *\{"server/exercise", \{"common",[^}]*\}\},\n'), ''),
         ('        const std::vector<Room> rest{\n', '''        static const std::string exercise = "server/exercise/";
        std::vector<std::string> in_exercise{"common", "words", physics + "..."};
        for (const char* room : {"weather", "definition", "picture", "faults", "talk", "watch", "tick"}) {
            list.push_back({exercise + room, in_exercise});
            in_exercise.push_back(exercise + room);
        }
        list.push_back({"server/exercise", in_exercise});
        const std::vector<Room> rest{
'''),
         (re.compile(r'"server/exercise"(?=[,}])(?!, in_exercise)'), '"server/exercise/..."'),
         (re.compile(r'(\{"recorder/debrief", \{"common", "idl", "recorder/recording", "station"), "recorder"\}'), r'\1}'),
         (re.compile(r'\{"recorder", \{"idl", "recorder/mcap", "recorder/recording", "station"\}\}'), '{"recorder", {"idl", "recorder/debrief", "recorder/mcap", "recorder/recording", "station"}}'),
    )
    edit('docs/architecture.md', ('\nData flows one way: commands', TABLE + '\nData flows one way: commands'))
    edit('README.md',
         ('| one tick ([exercise.cpp](server/exercise/exercise.cpp)), the table of faults, weather, orders of the bridge, the detector of events, what is published |',
          '| one tick ([exercise.cpp](server/exercise/exercise.cpp)); in rooms below it weather, definition, picture (what is published), faults, talk (orders, reports), watch (events) and the deck |'))
