#pragma once

#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "model/session/session.h"

/// Parts of a session as JSON and back, with the names of layers that the file has. A reader throws a std::exception
/// for JSON that is not as session.h shows it.
namespace model::session {

using Json = nlohmann::ordered_json;

/// Keys of a file that are no parts.
inline constexpr const char* kVersionKey = "copperscope_session";
inline constexpr const char* kJobKey = "job";

struct FileContent {
    Json json;  ///< an object
};

/// A part of what a file holds; null for one that is not there.
[[nodiscard]] const Json& partOf(const Json& file, const std::string& key);

[[nodiscard]] Json toJson(const SavedView& view);
[[nodiscard]] Json toJson(const SavedNet& net);
[[nodiscard]] Json toJson(const Desk& desk);
[[nodiscard]] Json toJson(const Measurement& measurement);
[[nodiscard]] Json toJson(const SavedSection& section);
[[nodiscard]] Json toJson(const LayerSet& set);
[[nodiscard]] Json toJson(const BoardColourChoice& chosen);

[[nodiscard]] SavedView viewFrom(const Json& json);
[[nodiscard]] SavedNet netFrom(const Json& json);
[[nodiscard]] Desk deskFrom(const Json& json);
[[nodiscard]] Measurement measurementFrom(const Json& json);
[[nodiscard]] SavedSection sectionFrom(const Json& json);
[[nodiscard]] LayerSet layerSetFrom(const Json& json);
[[nodiscard]] BoardColourChoice boardColoursFrom(const Json& json);
[[nodiscard]] Waiver waiverFrom(const Json& json);

/// What `read` makes of the JSON; nothing where it throws.
template <class Read>
[[nodiscard]] auto tryRead(const Json& json, const Read& read) {
    try {
        return std::optional(read(json));
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        return std::optional<decltype(read(json))>();
    }
}

/// An array whose items are as `read` wants them.
template <class Read>
[[nodiscard]] auto listFrom(const Json& json, const Read& read) {
    std::vector<decltype(read(json))> list;
    for (const Json& item : json.get_ref<const Json::array_t&>()) {
        list.push_back(read(item));
    }
    return list;
}

/// An array of what `write` makes of the items.
template <class List, class Write>
[[nodiscard]] Json listJson(const List& list, const Write& write) {
    Json json = Json::array();
    for (const auto& item : list) {
        json.push_back(write(item));
    }
    return json;
}

inline void require(bool isAsItShouldBe) {
    if (!isAsItShouldBe) {
        throw std::invalid_argument("not a session");
    }
}

[[nodiscard]] double numberFrom(const Json& json, double low, double high);
/// [x, y] in nm on a board.
[[nodiscard]] base::PointD pointFrom(const Json& json);
/// Two corners at least.
[[nodiscard]] std::vector<base::PointD> lineFrom(const Json& json);
[[nodiscard]] Json lineJson(const std::vector<base::PointD>& line);

}  // namespace model::session
