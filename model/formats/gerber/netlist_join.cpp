#include "model/formats/gerber/netlist_join.h"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>

#include "model/formats/common/shift.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

constexpr std::size_t kLength = 14;
constexpr Nm kReach = 15'000;

std::string plain(std::string_view name) {
    std::string text = upperCase(name);
    std::erase_if(text, [](char c) { return c == ' '; });
    return text;
}

}  // namespace

std::vector<std::string> fullNames(const std::vector<std::string>& names, const std::vector<formats::DrawnNet>& nets) {
    // Whole names first, then the last characters, which KiCad keeps, then the first ones.
    using Candidates = std::unordered_map<std::string, std::set<std::string>>;
    std::set<std::string> exact;
    std::array<Candidates, 3> ways;
    for (const formats::DrawnNet& net : nets) {
        exact.insert(net.name);
        const std::string text = plain(net.name);
        ways[0][text].insert(net.name);
        if (text.size() > kLength) {
            ways[1][text.substr(text.size() - kLength)].insert(net.name);
            ways[2][text.substr(0, kLength)].insert(net.name);
        }
    }
    std::vector<std::string> full;
    for (const std::string& name : names) {
        const std::string text = plain(name);
        const auto way = std::ranges::find_if(ways, [&](const Candidates& some) { return some.contains(text); });
        const bool isClear = !exact.contains(name) && way != ways.end() && way->at(text).size() == 1;
        full.push_back(isClear ? *way->at(text).begin() : name);
    }
    return full;
}

std::optional<Point> shiftOf(const D356& netlist, const PadIndex& pads) {
    std::vector<Point> points;
    for (const D356Point& point : netlist.points) {
        points.push_back(point.position);
    }
    return pads.shiftOf(points, kReach);
}

formats::DrawnNetlist drawnNetlist(const D356& netlist, const std::vector<std::string>& names, Point shift,
                                   std::string file) {
    formats::DrawnNetlist drawn;
    drawn.file = std::move(file);
    drawn.netlist.names = names;
    for (const D356Point& from : netlist.points) {
        if (from.net < 0) {
            continue;
        }
        formats::NetlistPoint point;
        point.number = from.net;
        point.line = from.line;
        point.position = formats::moved(from.position, shift);
        point.radius = from.height == 0 ? from.width / 2 : 0;
        point.width = from.width;
        point.height = from.height;
        point.exposure = from.exposure;
        point.isEnd = from.isEnd;
        point.isVia = from.isVia;
        point.side = from.access == 0 ? LayerSide::Through : from.access == 1 ? LayerSide::Top : LayerSide::Bottom;
        drawn.netlist.points.push_back(point);
    }
    return drawn;
}

}  // namespace model::gerber
