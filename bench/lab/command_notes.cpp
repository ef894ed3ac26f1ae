// What charts' data say of how they were made.

#include "bench/lab/commands.hpp"

#include <algorithm>

namespace windlass::lab {

void add_note(CLI::App& command, std::string& note) {
    command
        .add_option("--note", note,
                    "written above the data: date, machine, compiler and flags, commit; data that are only "
                    "made anew in part keep their notes and get this one too")
        ->type_name("TEXT");
}

Notes notes_after(const std::filesystem::path& file, bool anew, const std::string& note) {
    Notes notes = anew ? Notes() : read_notes(file);
    if (!note.empty() && std::ranges::count(notes, note) == 0) notes.push_back(note);
    return notes;
}

} // namespace windlass::lab
