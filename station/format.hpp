#pragma once
// Figures as a seaman reads them, each with its unit. Input is SI and radians, as on the wire.

#include <string>

namespace windlass::station {

std::string number(double value, int decimals); ///< "12.0", never "-0.0"
std::string clock(double seconds);              ///< "2:05", "1:02:05"; whole seconds, rounded down
std::string load(double newton);                ///< "443 kN (45 t)"; t is the weight of 1000 kg
std::string tonnes(double newton);              ///< "45 t"; "4.5 t" under 10
std::string cable(double metres);               ///< "88 m"
std::string shackles(double count);             ///< "3.2 shackles"
std::string in_shackles(double metres);         ///< the same of a length of cable
std::string cable_speed(double speed); ///< "4.1 m/s out", "0.15 m/s in", "stopped"; paying out positive
std::string knots(double speed);       ///< "0.6 kn"
std::string way(double surge);         ///< "ahead 0.6 kn", "astern 0.6 kn"
std::string bearing(double angle);     ///< "007": whole degrees clockwise from north, 000 to 359
std::string celsius(double kelvin);    ///< "180 degC"
std::string megajoules(double joule);  ///< "3.1 MJ"
std::string percent(double fraction);  ///< "10 %"
std::string lead(double clock_hours);  ///< "11 o'clock", "12 o'clock" for ahead

} // namespace windlass::station
