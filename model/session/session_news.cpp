#include "model/session/session_news.h"

#include "model/session/session_json.h"

namespace model::session {

std::vector<std::string> otherNews(const KnownPart& saved, const FileContent* before) {
    const Json none = Json::object();
    const Json& old = before != nullptr ? before->json : none;
    Json all = old;
    all.update(saved.file->json);  // for its keys
    std::vector<std::string> news;
    for (const auto& [key, value] : all.items()) {
        const bool isOther = key != kVersionKey && key != kJobKey && !saved.own->json.contains(key);
        if (isOther && old.value(key, Json()) != saved.file->json.value(key, Json())) {
            news.push_back(key);
        }
    }
    return news;
}

}  // namespace model::session
