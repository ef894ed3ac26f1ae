#include "recorder/debrief/lesson_text.hpp"

#include <nlohmann/json.hpp>

namespace windlass::debrief {

using nlohmann::json;

namespace {

std::string text_of(const json& from, const char* name) {
    const auto found = from.find(name);
    return found != from.end() && found->is_string() ? found->get<std::string>() : std::string();
}

} // namespace

LessonText lesson_text(const std::string& name, const std::string& text) {
    LessonText lesson;
    const json file = json::parse(text, nullptr, false);
    if (!file.is_object()) return lesson;
    lesson.name = name;
    lesson.json = text;
    const auto found = file.find("lesson");
    if (found == file.end() || !found->is_object()) return lesson;
    lesson.taught = true;
    lesson.title = text_of(*found, "title");
    for (const json& each : found->value("questions", json::array()))
        if (each.is_string()) lesson.questions.push_back(each.get<std::string>());
    return lesson;
}

LessonText lesson_text(recording::Recording& recording) {
    LessonText exercise;
    for (const auto& file : recording.files()) {
        for (const auto& attachment : file->attachments()) {
            if (!attachment.name.ends_with(".json")) continue;
            try {
                auto text = lesson_text(attachment.name, file->content(attachment));
                if (text.taught) return text;
                if (exercise.json.empty() && attachment.name.starts_with("exercises/"))
                    exercise = std::move(text);
            } catch (const mcap::Damage&) {
                continue; // a recording that was cut off may have lost it
            }
        }
    }
    return exercise;
}

std::map<std::string, std::string> limited_by(const LessonText& lesson) {
    std::map<std::string, std::string> all;
    const json file = json::parse(lesson.json, nullptr, false);
    if (!lesson.taught || !file.is_object()) return all;
    for (const json& each : file.at("lesson").value("criteria", json::array()))
        if (each.is_object()) all.emplace(text_of(each, "id"), text_of(each, "of"));
    return all;
}

} // namespace windlass::debrief
