#!/usr/bin/env python3
"""Namespaces follow rooms. Works on the files below the given root; idempotent."""
import collections, os, re, subprocess, sys

root = sys.argv[1]
os.chdir(root)
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

# ---- files that change their rooms -------------------------------------------------------------------------------
EXERCISE = {
    'weather': ['tide', 'weather', 'weather_rows', 'weather_table'],
    'definition': ['def_fields', 'exercise_def', 'fault_code', 'fault_order', 'orders'],
    'picture': ['published', 'snapshot', 'views'],
    'faults': ['fault_table', 'faults'],
    'talk': ['bridge_orders', 'lights_and_shapes', 'talk'],
    'watch': ['event_detector', 'ground_watch', 'model_watch', 'riding', 'watch_circle'],
    'tick': ['deck'],
}
STEMS = {stem: room for room, stems in EXERCISE.items() for stem in stems}

def tracked():
    out = subprocess.run(['git', 'ls-files', '-co', '--exclude-standard'], capture_output=True, text=True, check=True).stdout
    return [f for f in out.splitlines() if os.path.isfile(f)]

def move(old, new):
    if not os.path.isfile(old): return
    os.makedirs(os.path.dirname(new), exist_ok=True)
    if subprocess.run(['git', 'mv', '-k', old, new], capture_output=True).returncode or os.path.isfile(old):
        os.rename(old, new)

# ---- namespaces by room ------------------------------------------------------------------------------------------
# folder prefix -> (namespaces that it had, the one that it gets); the longest prefix counts.
NAMES = {
    'common': (['exercise', 'server'], ''),
    'server/config': (['exercise'], 'config'),
    'server/run': (['server'], 'run'),
    'server/dds': (['server'], 'dds'),
    'server/host': (['server'], 'host'),
    'server/perceive': (['server'], 'perceive'),
    'recorder/recording': (['recorder'], 'recording'),
    'rigs': (['exercise', 'physics', 'test'], 'rigs'),
    'tests/config': (['exercise'], 'config'),
    'tests/run': (['server'], 'run'),
    'tests/dds': (['server'], 'dds'),
    'tests/host': (['server'], 'host'),
    'tests/perceive': (['server'], 'perceive'),
    'tests/wire': (['server'], 'host'),
    'tests/acceptance': ([], 'lab'),
}
BENCH = (['exercise', 'lab'], 'bench')  # the files of bench/ itself

def rule(path):
    folder = os.path.dirname(path)
    if folder == 'bench': return BENCH
    best = None
    for prefix in NAMES:
        if (folder == prefix or folder.startswith(prefix + '/')) and (best is None or len(prefix) > len(best)):
            best = prefix
    return NAMES[best] if best else ([], None)

# Namespaces whose names are looked at, and where their headers lie.
HEADERS = ['common', 'server', 'idl', 'recorder/recording', 'rigs', 'bench', 'tests']

def masked(text):
    """The text with comments, strings and #-lines blanked, place by place."""
    pattern = re.compile(
        r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#[^\n]*(?:\\\n[^\n]*)*',
        re.S | re.M)
    def blank(m):
        if m.group(0).lstrip().startswith('#define'): return m.group(0)
        return re.sub(r'[^\n]', ' ', m.group(0))
    return pattern.sub(blank, text)

def namespaces(text):
    """The namespaces below windlass that a file opens, as written."""
    return re.findall(r'^\s*(?:inline )?namespace windlass(?:::([\w:]+))? \{', masked(text), re.M)

def declared(files):
    """(namespace, name) -> set of (file) for what headers declare in a namespace itself."""
    found = collections.defaultdict(set)
    kinds = {}
    out = subprocess.run(['ctags', '--languages=C++', '--langmap=C++:+.hpp', '--kinds-C++=pfvtcsgu', '--fields=+Ks', '-f', '-'] + files,
                         capture_output=True, text=True, check=True).stdout
    for line in out.splitlines():
        parts = line.split('\t')
        if line.startswith('!') or len(parts) < 5: continue
        name, path, kind = parts[0], parts[1], parts[3]
        scope = [p for p in parts[4:] if re.match(r'(namespace|class|struct|enum|function|union):', p)]
        if len(scope) != 1 or not scope[0].startswith('namespace:windlass'): continue
        space = scope[0][len('namespace:windlass'):].lstrip(':')
        if '__anon' in space or name.startswith('operator') or name.startswith('__anon') or '~' in name: continue
        found[space, name].add(path)
        kinds[space, name] = kind
    for path in files: # what a namespace has of another
        text = open(path, encoding='utf-8').read()
        space = namespaces(text)
        for name in re.findall(r'^using [\w:]+::(\w+);', text, re.M):
            if len(space) == 1: found[space[0], name].add(path); kinds[space[0], name] = 'using'
    return found, kinds

def main():
    for stem, room in STEMS.items():
        for kind in ('.hpp', '.cpp'):
            move(f'server/exercise/{stem}{kind}', f'server/exercise/{room}/{stem}{kind}')
    move('recorder/debrief/command_debrief.cpp', 'recorder/command_debrief.cpp')

    files = tracked()
    # Paths in what is read: includes, CMake, documents, comments.
    stems = '|'.join(STEMS)
    for path in files:
        if not re.search(r'\.(cpp|hpp|txt|cmake|md|ts|mjs|idl|json|yml|h)$|(^|/)check$', path): continue
        if path.startswith('docs/charts/') or 'node_modules' in path: continue
        try: text = open(path, encoding='utf-8', newline='').read()
        except UnicodeDecodeError: continue
        new = re.sub(rf'\bserver/exercise/({stems})\b(?=\.(?:hpp|cpp)|`)', lambda m: f'server/exercise/{STEMS[m[1]]}/{m[1]}', text)
        new = re.sub(rf'(?<![\w/])exercise/({stems})\.(hpp|cpp)\b', lambda m: f'exercise/{STEMS[m[1]]}/{m[1]}.{m[2]}', new)
        if path == 'server/exercise/CMakeLists.txt':
            new = re.sub(rf'(?<![\w/])({stems})\.cpp', lambda m: f'{STEMS[m[1]]}/{m[1]}.cpp', new)
        if path == 'recorder/CMakeLists.txt':
            new = new.replace('debrief/command_debrief.cpp', 'command_debrief.cpp')
        if new != text: open(path, 'w', encoding='utf-8', newline='').write(new)

    sources = [f for f in tracked() if f.endswith(('.cpp', '.hpp'))]
    headers = [f for f in sources if f.endswith('.hpp') and f.startswith(tuple(h + '/' for h in HEADERS))]
    names, kinds = declared(headers)
    # Where each name is now and where it goes: (old namespace, name) -> new namespace.
    goes = {}
    for (space, name), where in names.items():
        targets = set()
        for path in where:
            olds, new = rule(path)
            top, _, rest = space.partition('::')
            if top in olds and new is not None:
                targets.add('::'.join(p for p in (new, rest) if p))
            else:
                targets.add(space)
        if len(targets) == 1:
            goes[space, name] = targets.pop()
        else: # declared in several: the moved one, unless ambiguous
            goes[space, name] = sorted(targets)
    import special
    for path in sources:
        text = open(path, encoding='utf-8').read()
        new = special.before(path, text)
        new = rewrite(path, new, goes, kinds)
        new = special.after(path, new)
        if new != text: open(path, 'w', encoding='utf-8').write(new)
    special.whole_tree()
    changed = [f for f in subprocess.run(['git', 'diff', '--name-only', 'HEAD', '--diff-filter=d'], capture_output=True, text=True).stdout.splitlines()
               if f.endswith(('.cpp', '.hpp'))]
    if changed: subprocess.run(['clang-format', '-i'] + changed, check=True)

def rewrite(path, text, goes, kinds):
    import special
    olds, own_new = rule(path)
    spaces = namespaces(text)
    old_scopes = []  # namespaces that unqualified names are looked up in, beside windlass itself
    for space in spaces:
        parts = space.split('::') if space else []
        for n in range(len(parts), 0, -1):
            old_scopes.append('::'.join(parts[:n]))
    for used in re.findall(r'using namespace (?:windlass::)?([\w:]+);', masked(text)):
        if used not in ('windlass',): old_scopes.append(used)
    def renamed(space):
        top, _, rest = space.partition('::')
        if top in olds and own_new is not None: return '::'.join(p for p in (own_new, rest) if p)
        return space
    new_scopes = {renamed(s) for s in old_scopes} | {''}
    inside = bool(spaces) or 'using namespace windlass;' in text
    mask = masked(text)
    edits = []
    # qualified
    for m in re.finditer(r'(?<![\w:])(::)?(windlass::)?((?:\w+::)+)(\w+)', mask):
        space, name = m[3][:-2], m[4]
        full = None
        if (space, name) in goes: full = (space, name)
        else: # Class::member, nested deeper: find the longest prefix that is namespace + name
            parts = space.split('::')
            for n in range(len(parts) - 1, 0, -1):
                key = ('::'.join(parts[:n]), parts[n])
                if key in goes: full = key; break
            if full is None:
                # relative to the file's own namespaces: run::x, test::x
                for scope in old_scopes:
                    if (f'{scope}::{space}', name) in goes:
                        full = None
                        break
        if full is None: continue
        target = goes[full]
        if isinstance(target, list): target = special.choose(path, full, target)
        if target == full[0]: continue
        begin = m.start(3)
        end = begin + len(full[0]) + 2
        prefix = m[2] or ''
        if target == '':
            replacement = ''
            if not prefix and not inside: replacement = 'windlass::'
        else: replacement = target + '::'
        edits.append((begin, end, replacement))
    # unqualified
    for m in re.finditer(r'(?<![\w.~])(?<!->)(?<!::)[A-Za-z_]\w*(?!\w)', mask):
        name = m[0]
        scope = next((s for s in old_scopes if (s, name) in goes), None)
        if scope is None: continue
        target = goes[scope, name]
        if isinstance(target, list): target = special.choose(path, (scope, name), target)
        if target in new_scopes or target == '': continue
        tail = mask[m.end():m.end() + 2]
        if tail.startswith('::') and False: continue
        if re.search(r'(?:->|\.)\s*$', mask[max(0, m.start() - 3):m.start()]): continue
        if name[0].islower():
            if (scope, name) in special.ADL or kinds[scope, name] in ('function', 'prototype') and not re.match(r'\s*[(<]', mask[m.end():m.end() + 3]): continue
            before = mask[:m.start()].rstrip()
            if re.search(r'[\w>&*]$', before) and not re.search(r'(?:\breturn|\bco_return|\belse|\bcase|\b&&|&&|\*|&)$', before): continue
        if special.keep(path, scope, name, mask, m): continue
        edits.append((m.start(), m.start(), target + '::'))
    # the file's own namespaces
    if own_new is not None:
        for old in olds:
            for m in re.finditer(rf'\bnamespace windlass::{old}\b(?=(?:::[\w:]+)? \{{|(?:::[\w:]+)?;|(?:::[\w:]+)?\s*$)', text, re.M):
                if special.keep_namespace(path, old, text, m): continue
                edits.append((m.start(), m.end(), 'namespace windlass' + (f'::{own_new}' if own_new else '')))
    # Tests stand on the rigs: one directive instead of a word before each of many names.
    rig_edits = [e for e in edits if e[0] == e[1] and e[2] == 'rigs::']
    if path.endswith('.cpp') and path.startswith(('tests/', 'bench/acceptance')) and spaces and len(rig_edits) > 3:
        edits = [e for e in edits if e not in rig_edits]
        opened = re.search(r'^namespace windlass[\w:]* \{\n\n?', text, re.M)
        more = text[opened.end():]
        edits.append((opened.end(), opened.end(), 'using namespace rigs;\n' + ('' if more.startswith('using ') else '\n')))
    for begin, end, replacement in sorted(set(edits), reverse=True):
        text = text[:begin] + replacement + text[end:]
    return text

if __name__ == '__main__': main()
