#pragma once
// Sessions that learning systems have started, and their statements on the way to them: kept in files until
// the record store has them, posted in their order, again and again while it does not. Time is given.

#include "door/cmi5/statements.hpp"

#include <map>

namespace windlass::cmi5 {

struct Session {
    std::string id;        ///< ours, a UUID
    std::string lesson;    ///< name of its exercise file
    std::string lesson_id; ///< as the learner knows it
    std::string name;      ///< of the learner, here
    std::string endpoint, token;
    std::string fetch;   ///< digest of its address
    std::string browser; ///< digest of the cookie of the one that came by it
    About about;
    std::string return_url;
    std::int64_t began_unix_ms = 0;
    bool started = false;              ///< the exercise
    bool closed = false;               ///< its last statement was made
    std::string verdict;               ///< passed, failed; empty: none
    std::optional<double> points = {}; ///< 0..100

    std::vector<nlohmann::json> waiting; ///< statements that the record store has not yet, in order
    int tries = 0;                       ///< of the first of them
    std::int64_t next_unix_s = 0;        ///< when to try again
    std::int64_t since_unix_s = 0;       ///< when it was tried first; 0: it was not
    std::int64_t done_unix_s = 0;        ///< when nothing waited any more after the last; 0: it does
};

/// One thread.
class Outbox {
public:
    static constexpr std::int64_t kFirstPause = 2, kLongestPause = 900; ///< s between tries
    static constexpr std::int64_t kGivenUp = 14 * 24 * 3600;            ///< s of trying
    static constexpr std::int64_t kKept = 3600; ///< s for which a session that is done can be asked for

    using Write = std::function<void(const std::filesystem::path& file, const std::string& text)>;

    /// Reads the folder's sessions, where there is one. write: keeps a file whole. Throws std::runtime_error
    /// naming the file that is none.
    Outbox(std::filesystem::path folder, Write write);

    const std::map<std::string, Session>& sessions() const { return sessions_; }
    const Session* find(const std::string& id) const;
    /// The newest that browser came by; nullptr: none.
    const Session* of_browser(const std::string& browser) const;
    /// That address' token was fetched for; nullptr: it is none that is known.
    const Session* of_fetch(const std::string& fetch) const;

    /// A new one, or another state of one that is there. Throws std::runtime_error when it cannot be kept.
    void put(Session session);
    /// More statements of a session, and last: its last ones. The same.
    void add(const std::string& id, std::vector<nlohmann::json> statements, bool last);

    /// Sessions whose next statement may be tried now; none that is being tried.
    std::vector<std::string> due(std::int64_t now_unix_s);
    /// It is being tried, until one of the next three.
    void begin(const std::string& id, std::int64_t now_unix_s);
    /// The record store has it. Returns its verb's last part.
    std::string posted(const std::string& id, std::int64_t now_unix_s);
    /// It has not: tried again after a pause that doubles. False: it is given up, with all behind it.
    bool failed(const std::string& id, std::int64_t now_unix_s);
    /// It was not tried after all.
    void put_off(const std::string& id);

    /// Sessions that were done for longer than kKept are gone.
    void forget_old(std::int64_t now_unix_s);

private:
    void keep(const Session& session);
    void done_if_empty(Session& session, std::int64_t now_unix_s);

    const std::filesystem::path folder_;
    const Write write_;
    std::map<std::string, Session> sessions_; // by id
    std::map<std::string, bool> trying_;
};

} // namespace windlass::cmi5
