#pragma once
// When the picture of a cable is worth sending.

#include "server/exercise/picture/snapshot.hpp"

namespace windlass::dds {

/// Thins out the pictures of a cable that lies still to 5 Hz of exercise time: one in which no node is more
/// than 2 mm from where it was last told, no link's tension more than 0.2 % of the largest from what was last
/// told of it, and no more cable out by a millimetre. What moves is told at once, however often it is asked.
class StillCable {
public:
    /// Whether to send this picture, of that exercise time (s); takes it as sent when so. One of the same
    /// time as the last that was asked for, or an earlier one, always is: the exercise stands still, or was
    /// set back.
    bool due(const exercise::ChainView& chain, double time);

private:
    bool moved(const exercise::ChainView& chain) const;

    double sent_ = 0, asked_ = -1; // s of exercise time
    double cable_out_ = 0;
    std::vector<Eigen::Vector3f> nodes_;
    std::vector<float> tension_;
};

} // namespace windlass::dds
