"""What no rule covers."""
import os, re

ADL = set()  # functions that are found by their arguments

def before(path, text): return text
def after(path, text):
    text = re.sub(r'^using (?:windlass::)?ConfigError;\n', '', text, flags=re.M) # in windlass itself
    if path.startswith('bench/') and path.count('/') == 1 and 'using namespace windlass::bench;' in text and 'using namespace windlass;' not in text:
        text = text.replace('using namespace windlass::bench;', 'using namespace windlass;\nusing namespace windlass::bench;')
    if path == 'server/exercise/picture/views.hpp':
        text = text.replace('#include "server/exercise/state_hash.hpp"\n', '')
    if path == 'tests/recorder/taped_session.hpp':
        text = re.sub(r'(?<![\w:])convert\(session_', 'dds::convert(session_', text)
    return text
from tree import whole_tree
def choose(path, key, targets): return key[0] if key[0] in targets else targets[0]
def keep(path, scope, name, mask, m):
    # a name of the file's own
    if name[0].islower() and re.search(rf'^(?!return|using)[A-Za-z][\w:<>,&* ]*[ &*]{name}\(', mask[:m.start()], re.M): return True
    if re.search(rf'\b(?:struct|class|enum|enum class|using) {name}\b(?= (?:final )?(?:\{{|:|=))', mask): return True
    if re.search(rf'^(?:inline |static )?const(?:expr)? [\w:]+ {name}\b', mask, re.M) and path.startswith('tests/'): return True
    if name[0].islower() and re.search(rf'\b[A-Z]\w*::{name}\(', mask): return True # a member function
    if path == 'server/dds/publisher.cpp' and name in ('forecastle', 'bridge', 'camera'): return True
    return (scope, name) in {('server', 'name')}
def keep_namespace(path, old, text, m):
    # a block of forward declarations of another room
    return re.match(r'[^\n]*\n(?:\s*(?:struct|class) \w+;\s*\n)+\}', text[m.end():]) is not None and path.startswith('server/exercise')
