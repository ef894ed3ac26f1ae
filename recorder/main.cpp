// recorder: writes an exercise down, shows it again, and tells what is in a recording.

#include "recorder/command.hpp"
#include "recorder/mcap/bytes.hpp"
#include "recorder/recording/recording.hpp"
#include "station/options.hpp"

#include <iostream>

int main(int argc, char** argv) {
    using namespace windlass::recorder;
    CLI::App app{"Records Windlass exercises to MCAP files, and replays them."};
    app.set_version_flag("--version", std::string("recorder ") + WINDLASS_VERSION);
    Command chosen;
    add_record(app, chosen);
    add_record_many(app, chosen);
    add_info(app, chosen);
    add_replay(app, chosen);
    add_control(app, chosen);
    add_debrief(app, chosen);
    add_class(app, chosen);
    add_export(app, chosen);
    add_assess(app, chosen);
    add_blind(app, chosen);
    add_resimulate(app, chosen);
    add_whatif(app, chosen);
    app.require_subcommand(0, 1);
    app.footer("Exit codes: 0 done, 1 failed, 2 bad option, 3 a recording could not be read, or not all of "
               "it, or is\n"
               "of another version of the wire,\n"
               "4 a live server is where the replay was to go, 5 disk full or too little room,\n"
               "6 what comes of the recorded orders is not what was recorded.");
    if (const auto code = windlass::station::parse(app, argc, argv)) return *code;
    if (!chosen) {
        std::cerr << "A subcommand is required\n" << app.help();
        return kBadOption;
    }
    try {
        return windlass::station::leave(chosen());
    } catch (const windlass::mcap::Damage& error) {
        tell(error.what());
        return kDamaged;
    } catch (const windlass::recording::VersionError& error) {
        tell(error.what());
        return kDamaged;
    } catch (const std::exception& error) {
        tell(error.what());
        return kFailed;
    }
}
