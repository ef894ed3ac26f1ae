#include "lesson/beside.hpp"

#include "lesson/play_on.hpp"

#include <stdexcept>

namespace windlass::lesson {

namespace {

std::vector<trainee::Script> scripts_of(const run::Course& course, const std::filesystem::path& config) {
    const assess::Lesson* lesson = course.assessor().lesson();
    if (lesson == nullptr || lesson->model_run.scripts.empty())
        throw std::runtime_error(course.exercise().def().name + ": has no lesson with a model run");
    std::vector<trainee::Script> scripts;
    for (const std::string& script : lesson->model_run.scripts)
        scripts.push_back(trainee::load_script(config / script, trainee::Eyes::seat));
    return scripts;
}

class Beside final : public run::ModelHands {
public:
    Beside(const run::Beginning& beginning, const std::filesystem::path& config)
        : course_(run::beginning_of(beginning.def, beginning.seed)),
          hands_(course_, scripts_of(course_, config)) {}

    std::uint64_t tick() const override { return course_.exercise().tick(); }
    void take(const exercise::Order& order) override {
        // Where they have the conn, theirs are the orders of the bridge.
        if (std::holds_alternative<exercise::BridgeOrderGiven>(order) && hands_.conned()) return;
        hands_.take(order);
    }
    bool step() override {
        if (hands_.over()) return false;
        hands_.step();
        return true;
    }
    const exercise::Snapshot& seen() override { return hands_.seen(); }
    const assess::State& state() const override { return course_.assessor().state(); }
    const exercise::ExerciseDef& def() const override { return course_.exercise().def(); }

private:
    run::Course course_;
    PlayedOn hands_;
};

} // namespace

std::unique_ptr<run::ModelHands> model_beside(const run::Beginning& beginning,
                                              const std::filesystem::path& config) {
    return std::make_unique<Beside>(beginning, config);
}

} // namespace windlass::lesson
