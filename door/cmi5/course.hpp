#pragma once
// The course that a learning system takes in: cmi5.xml, by CourseStructure.xsd of the cmi5 specification,
// Quartz edition, section 13.

#include <string>
#include <vector>

namespace windlass::cmi5 {

/// As a learner may read it beforehand: no word of what is to come.
struct CourseLesson {
    std::string id; ///< of the lesson, by which it is started
    std::string title, description;
    int pass = 70; ///< points of 100
};

/// One unit to a lesson, each to be passed. door: its origin, "https://door.example:8443"; the ids are made
/// of it, so that a course that is made again has the same.
std::string course_xml(const std::string& door, const std::vector<CourseLesson>& lessons);

} // namespace windlass::cmi5
