#include "model/session/session_news.h"

#include "model/session/session_json.h"

namespace model::session {

std::vector<std::string> otherNews(const KnownPart& saved, const FileContent* before) {
    const Json none = Json::object();
    const Json& old = before != nullptr ? before->json : none;
    const Json& now = saved.file->json;
    std::vector<std::string> news;
    const auto add = [&](const std::string& key) {
        const bool isOther = key != kVersionKey && key != kJobKey && !saved.own->json.contains(key);
        if (isOther && partOf(old, key) != partOf(now, key)) {
            news.push_back(key);
        }
    };
    for (const auto& [key, value] : old.items()) {
        add(key);
    }
    for (const auto& [key, value] : now.items()) {
        if (!old.contains(key)) {
            add(key);
        }
    }
    return news;
}

}  // namespace model::session
