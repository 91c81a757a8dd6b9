#include "tests/soak/action_log.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>

namespace soak {

namespace {

constexpr int kSignals[] = {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT};

void put(std::string_view text) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    (void)written;  // there is nobody left to tell
}

void onSignal(int signal) {
    ActionLog::instance().print();
    std::signal(signal, SIG_DFL);
    (void)std::raise(signal);
}

template <class Line>
void copyInto(Line& line, std::string_view text) {
    const std::size_t size = std::min(text.size(), line.size() - 1);
    std::memcpy(line.data(), text.data(), size);
    line[size] = '\0';
}

}  // namespace

ActionLog& ActionLog::instance() {
    static ActionLog log;
    return log;
}

void ActionLog::watchFailures(std::string_view replay) {
    copyInto(m_replay, replay);
    for (const int signal : kSignals) {
        std::signal(signal, onSignal);
    }
}

void ActionLog::add(std::string_view action) {
    const std::size_t count = m_count;
    copyInto(m_lines[count % kKept], action);
    m_count = count + 1;
}

std::string_view ActionLog::current() const {
    const std::size_t count = m_count;
    return count == 0 ? std::string_view() : std::string_view(m_lines[(count - 1) % kKept].data());
}

void ActionLog::print() const {
    const std::size_t count = m_count;
    put("soak: the last actions, the newest at the end:\n");
    for (std::size_t i = count - std::min(count, kKept); i < count; ++i) {
        put("  ");
        put(m_lines[i % kKept].data());
        put("\n");
    }
    put("soak: again with: ");
    put(m_replay.data());
    put("\n");
}

}  // namespace soak
