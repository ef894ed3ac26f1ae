#pragma once
// What a seat's page may hear and order: the roles of config/security/roles.txt, but for what no page needs.

#include "idl/topics.hpp"
#include "station/client.hpp"

#include <string>
#include <vector>

namespace windlass::gateway {

using Topics = std::vector<const wire::TopicInfo*>;

/// What every page of a seat is given, and may order by.
struct Role {
    std::string name;               ///< forecastle, conning, trainee, instructor
    Topics hears;                   ///< in the exercise's partition
    Topics writes;                  ///< there
    Topics classroom_hears;         ///< in partition "classroom"
    Topics classroom_writes;        ///< there
    std::vector<std::string> pages; ///< that the program offers its addresses of, the first one first
};

/// Every topic of the role in that exercise (NAME without "exercise/"), but Checkpoint, of which a page makes
/// nothing. A name that begins with "replay" is a replay's, where the seats hear all: that is the debriefing.
Role role_of(station::Seat seat, const std::string& exercise);

/// Whether it may have recordings shown, and seek in them.
bool may_replay(station::Seat seat);

/// The row of that name, of the exercises' topics or the classroom's; nullptr: none.
const wire::TopicInfo* find_topic(const std::string& name);

/// Lever states, which go out as long as a hand has them, and are no orders.
bool is_lever_topic(const wire::TopicInfo& topic);

} // namespace windlass::gateway
