#pragma once
// Names of threads, for who looks at where a program's time goes (ps -L, top -H).

#include <pthread.h>

#include <string>

namespace windlass {

/// Names the calling thread, for its life or that of the object, and with it every thread that it starts
/// meanwhile: Linux hands names down. 15 characters at most.
class ThreadName {
public:
    explicit ThreadName(const char* name) {
        pthread_getname_np(pthread_self(), before_, sizeof before_);
        pthread_setname_np(pthread_self(), name);
    }
    ~ThreadName() { pthread_setname_np(pthread_self(), before_); }
    ThreadName(const ThreadName&) = delete;
    ThreadName& operator=(const ThreadName&) = delete;

private:
    char before_[16] = {};
};

} // namespace windlass
