#include "model/session/saved_nets.h"

#include <charconv>
#include <unordered_map>

#include "model/text/formatting.h"

namespace model::session {

std::vector<std::optional<BoardNet>> findNets(const StepTree& tree, std::span<const SavedNet> nets) {
    std::vector<std::optional<BoardNet>> found(nets.size());
    for (std::uint32_t step = 0; !nets.empty() && step < tree.steps.size(); ++step) {
        std::unordered_map<std::string_view, NetId> byName;
        for (std::size_t row = 0; row < tree.steps[step]->nets.size(); ++row) {
            byName.try_emplace(tree.steps[step]->nets[row].name, NetId{row});
        }
        for (std::size_t i = 0; i < nets.size(); ++i) {
            const auto net = byName.find(nets[i].name);
            if (nets[i].step == tree.steps[step]->job.step && net != byName.end()) {
                found[i] = BoardNet{step, net->second};
            }
        }
    }
    return found;
}

std::optional<std::uint32_t> colourFrom(std::string_view text) {
    constexpr std::size_t kLength = 7;
    std::uint32_t colour = 0;
    if (text.size() != kLength || text.front() != '#') {
        return std::nullopt;
    }
    const char* end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data() + 1, end, colour, 16);
    return error == std::errc() && last == end ? std::optional(colour) : std::nullopt;
}

std::string colourText(std::uint32_t colour) {
    return formatted("#%06x", colour & 0xffffffU);
}

}  // namespace model::session
