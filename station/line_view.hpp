#pragma once
// The exercise in one line of text, for a terminal that only scrolls and for a log.

#include "station/seen.hpp"

#include <string>

namespace windlass::station {

/// E.g. `2:05 running x8.0  port 88 m 3.2 shackles  4.1 m/s out  load 443 kN (45 t) 10 %  brake 40 % ...`.
/// Cable and load are what the onlooker can know. Says so when the server has not been heard, or not for more
/// than kStaleAfter.
std::string line(const Picture& picture, int side, Clock::time_point now, Onlooker who);

/// `port: anchor let go`: the event's text, and before it whose it is unless the text says so, and in
/// capitals how bad where that is worse than info.
std::string told(const Event& event);
std::string told(const SeatEvent& event);

/// `2:05 * port: anchor let go`
std::string line(const Event& event);
std::string line(const SeatEvent& event);

/// `2:05 # order 3: port: hold on at 6 shackles (given)`
std::string line(const BridgeOrder& order);

/// `2:05 ALARM: port: drive tripped; lever to zero (windlass.tripped, acknowledged)`
std::string line(const Alert& alert);

/// s without a sample, after which figures are old.
inline constexpr double kStaleAfter = 1.5;

} // namespace windlass::station
