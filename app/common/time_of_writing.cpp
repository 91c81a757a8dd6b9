#include "app/common/time_of_writing.h"

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <string_view>

namespace app {

namespace {

constexpr std::time_t kLastOfYear9999 = 253'402'300'799;  // years of more digits are no ISO 8601

}  // namespace

base::Result<std::string> timeOfWriting() {
    std::time_t time = std::time(nullptr);
    if (const char* set = std::getenv("SOURCE_DATE_EPOCH"); set != nullptr && *set != '\0') {
        const std::string_view text(set);
        const auto read = std::from_chars(text.data(), text.data() + text.size(), time);
        if (read.ec != std::errc() || read.ptr != text.data() + text.size() || time < 0 || time > kLastOfYear9999) {
            return base::Error{base::ErrorCode::BadUsage,
                               "SOURCE_DATE_EPOCH is " + std::string(text) + ", no number of seconds since 1970"};
        }
    }
    std::tm parts{};
    char text[32] = {};
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&time, &parts));
    return std::string(text);
}

}  // namespace app
