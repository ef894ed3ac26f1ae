#include "instructor_console/classroom_command.hpp"

#include "station/json_view.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace windlass::console {

namespace {

std::string read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in || text.empty()) throw std::runtime_error(file.string() + " cannot be read, or is empty");
    return text;
}

CLI::Validator exercise_name() {
    return {[](const std::string& text) {
                return wire::is_exercise_name(text)
                           ? ""
                           : text + " is not allowed: letters, digits, - _ . only, 1..64 of them";
            },
            ""};
}

} // namespace

void add_classroom(CLI::App& app, ClassroomOptions& options, const std::function<void()>& chosen) {
    using What = ClassroomOptions::What;
    CLI::App* classroom =
        app.add_subcommand("classroom", "the servers of the domain and their exercises, all at once");
    classroom->fallthrough();
    classroom->require_subcommand(1);
    const auto add = [&](const char* name, const char* text, What what) {
        CLI::App* sub = classroom->add_subcommand(name, text);
        sub->fallthrough();
        sub->callback([&options, chosen, what] {
            options.what = what;
            chosen();
        });
        return sub;
    };
    add("list", "every server with its exercises", What::list);

    CLI::App* create = add("create", "open an exercise beside those that run", What::create);
    create->add_option("id", options.exercise.id, "its name; stations join it by --partition ID")
        ->required()
        ->check(exercise_name());
    auto* file =
        create->add_option("--exercise", options.exercise.file, "its file in the server's exercise folder");
    auto* definition =
        create->add_option("--definition", options.definition, "its file here, which is sent to the server")
            ->type_name("FILE")
            ->check(CLI::ExistingFile);
    file->excludes(definition);
    create->add_flag("--practice", options.exercise.practice,
                     "its lesson is played for practice: with hints, and not as a test");
    create->add_flag("--wait", options.exercise.wait, "begin ready, and start on order");
    create->add_option("--server", options.exercise.server,
                       "which server; without, the one that has the fewest");
    CLI::App* remove = add("remove", "end an exercise and leave its partition", What::remove);
    remove->add_option("id", options.exercise.id, "its name")->required()->check(exercise_name());
    remove->add_option("--server", options.exercise.server, "which server; without, the one that has it");
}

Answer carry_out(const ClassroomOptions& options, const wire::JoinOptions& session, double timeout) {
    if (options.what == ClassroomOptions::What::remove)
        return remove_exercise(session, options.exercise.id, options.exercise.server, timeout);
    NewExercise wanted = options.exercise;
    if (!options.definition.empty()) wanted.definition = read(options.definition);
    return create_exercise(session, wanted, timeout);
}

nlohmann::json to_json(const std::vector<ClassroomStatus>& servers) {
    auto all = nlohmann::json::array();
    for (const ClassroomStatus& server : servers)
        all.push_back(station::to_json(server));
    return all;
}

} // namespace windlass::console
