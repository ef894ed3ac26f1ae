#include "door/cmi5/course.hpp"

#include "door/cmi5/url.hpp"

#include <fmt/format.h>

namespace windlass::cmi5 {

namespace {

/// Text of an element or attribute; what XML 1.0 cannot say is left out.
std::string xml(const std::string& text) {
    std::string made;
    for (const char c : text) {
        if (c == '&')
            made += "&amp;";
        else if (c == '<')
            made += "&lt;";
        else if (c == '>')
            made += "&gt;";
        else if (c == '"')
            made += "&quot;";
        else if (static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\t')
            made += c;
    }
    return made;
}

std::string said(const std::string& element, const std::string& text, const std::string& indent) {
    return fmt::format("{0}<{1}><langstring lang=\"en\">{2}</langstring></{1}>\n", indent, element,
                       xml(text));
}

} // namespace

std::string course_xml(const std::string& door, const std::vector<CourseLesson>& lessons) {
    const std::string base = door + "/cmi5/";
    std::string units;
    for (const CourseLesson& lesson : lessons) {
        const std::string address = xml(base + escaped(lesson.id));
        // A window of its own: no page of the door is shown within another site's.
        units +=
            fmt::format("  <au id=\"{}\" launchMethod=\"OwnWindow\" masteryScore=\"{}\" moveOn=\"Passed\" "
                        "activityType=\"http://adlnet.gov/expapi/activities/lesson\">\n",
                        address, lesson.pass / 100.0) +
            said("title", lesson.title, "    ") + said("description", lesson.description, "    ") +
            fmt::format("    <url>{}</url>\n  </au>\n", address);
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<courseStructure xmlns=\"https://w3id.org/xapi/profiles/cmi5/v1/CourseStructure.xsd\">\n" +
           fmt::format("  <course id=\"{}\">\n", xml(base + "course")) +
           said("title", "Windlass and anchoring", "    ") +
           said("description",
                "Lessons at a windlass simulator: each is worked in real time, marked by what was done, and "
                "passed when it is achieved.",
                "    ") +
           "  </course>\n" + units + "</courseStructure>\n";
}

} // namespace windlass::cmi5
