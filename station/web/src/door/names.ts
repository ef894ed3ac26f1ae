// Names out of a file that a table program has written: the first column, or the one that is headed so.

/** Names of a CSV's text, in its order; separated by comma, semicolon or tab; a line without one is left out. */
export function namesOf(text: string): string[] {
  const rows = text
    .replace(/^\uFEFF/, "")
    .split(/\r?\n/)
    .map(cells);
  const head = rows[0]?.findIndex((cell) => /^(name|trainee|student)$/i.test(cell)) ?? -1;
  const column = Math.max(0, head);
  return rows
    .slice(head < 0 ? 0 : 1)
    .map((row) => row[column] ?? "")
    .filter((name) => name !== "");
}

/** Of one line, RFC 4180: what stands in quotes may have separators, and a quote twice. */
function cells(line: string): string[] {
  const found = line.match(/("(?:[^"]|"")*"|[^,;\t]*)(?:[,;\t]|$)/g) ?? [];
  return found.map((cell) => {
    const bare = cell.replace(/[,;\t]$/, "").trim();
    return bare.startsWith('"') ? bare.slice(1, -1).replace(/""/g, '"').trim() : bare;
  });
}
