#include "model/board/board_colours.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "model/base/ascii.h"

namespace model {

namespace {

using Words = std::vector<std::string>;

/// Runs of letters in small letters: "SMT_Green-2" is "smt", "green".
Words wordsOf(std::string_view text) {
    Words words(1);
    for (const char letter : text) {
        if (base::lowerAscii(letter) != base::upperAscii(letter)) {
            words.back() += base::lowerAscii(letter);
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    return words;
}

void append(Words& words, std::string_view text) {
    std::ranges::move(wordsOf(text), std::back_inserter(words));
}

/// All that the job says about a layer of it.
Words wordsAbout(const Document& document, std::size_t row) {
    Words words = wordsOf(document.layers[row].name);
    append(words, document.layers[row].useName);
    if (row < document.stackup.facts.layers.size()) {
        append(words, document.stackup.facts.layers[row].material.name);
        append(words, document.stackup.facts.layers[row].material.type);
    }
    return words;
}

template <class Value>
std::optional<Value> valueNamed(const std::vector<std::string>& names, std::string_view name) {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<Value>(found - names.begin()));
}

std::optional<BoardColour> colourIn(const Words& words) {
    for (const std::string& word : words) {
        if (const std::optional<BoardColour> colour = boardColourNamed(word)) {
            return colour;
        }
    }
    return std::nullopt;
}

constexpr std::pair<std::string_view, SurfaceFinish> kFinishWords[] = {
    {"enig", SurfaceFinish::Gold}, {"enepig", SurfaceFinish::Gold}, {"hasl", SurfaceFinish::Tin},
    {"hal", SurfaceFinish::Tin},   {"osp", SurfaceFinish::Copper},  {"entek", SurfaceFinish::Copper},
    {"immag", SurfaceFinish::Tin}, {"imag", SurfaceFinish::Tin},    {"imsn", SurfaceFinish::Tin},
    {"isn", SurfaceFinish::Tin}};
/// Metals that say a finish only beside a word for one: gold is on edge connectors too.
constexpr std::pair<std::string_view, SurfaceFinish> kMetalWords[] = {{"gold", SurfaceFinish::Gold},
                                                                      {"tin", SurfaceFinish::Tin},
                                                                      {"silver", SurfaceFinish::Tin},
                                                                      {"bare", SurfaceFinish::Copper}};

std::optional<SurfaceFinish> finishIn(const Words& words) {
    const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
    for (const auto& [word, finish] : kFinishWords) {
        if (has(word)) {
            return finish;
        }
    }
    const bool isFinish = has("finish") || has("immersion") || has("surface");
    for (const auto& [word, finish] : kMetalWords) {
        if (isFinish && has(word)) {
            return finish;
        }
    }
    return std::nullopt;
}

template <class Value>
void setIfUnknown(std::optional<Value>& known, const std::optional<Value>& value) {
    known = known ? known : value;
}

/// Is the copper that lies nearest to a body, on either side, of the flexible parts alone?
bool isBetweenFlexibleCopper(const Document& document, const Layer& body) {
    const auto middleOf = [](const Layer& layer) { return std::int64_t{2} * layer.z + layer.thickness; };
    const Layer* above = nullptr;
    const Layer* below = nullptr;
    for (const Layer& layer : document.layers) {
        if (!layer.isCopper()) {
            continue;
        }
        if (middleOf(layer) > middleOf(body)) {
            above = above == nullptr || layer.z < above->z ? &layer : above;
        } else {
            below = below == nullptr || layer.z > below->z ? &layer : below;
        }
    }
    const auto isFlexible = [](const Layer* copper) { return copper == nullptr || copper->use == LayerUse::Flex; };
    return (above != nullptr || below != nullptr) && isFlexible(above) && isFlexible(below);
}

}  // namespace

const std::vector<std::string>& boardColourNames() {
    static const std::vector<std::string> names{"green", "red", "blue", "black", "white", "yellow", "purple"};
    return names;
}

const std::vector<std::string>& surfaceFinishNames() {
    static const std::vector<std::string> names{"gold", "tin", "copper"};
    return names;
}

std::optional<BoardColour> boardColourNamed(std::string_view name) {
    return valueNamed<BoardColour>(boardColourNames(), name);
}

std::optional<SurfaceFinish> surfaceFinishNamed(std::string_view name) {
    return valueNamed<SurfaceFinish>(surfaceFinishNames(), name);
}

BoardColourChoice coloursInJob(const Document& document) {
    BoardColourChoice known;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const Layer& layer = document.layers[row];
        if (layer.isSynthetic) {
            continue;
        }
        const Words words = wordsAbout(document, row);
        if (layer.type == LayerType::SolderMask) {
            setIfUnknown(known.solderMask, colourIn(words));
        } else if (layer.type == LayerType::SilkScreen) {
            setIfUnknown(known.silkscreen, colourIn(words));
        }
        setIfUnknown(known.finish, finishIn(words));
    }
    return known;
}

BoardColours boardColours(const Document& document, const BoardColourChoice& chosen) {
    BoardColourChoice known = chosen;
    const BoardColourChoice job = coloursInJob(document);
    setIfUnknown(known.solderMask, job.solderMask);
    setIfUnknown(known.silkscreen, job.silkscreen);
    setIfUnknown(known.finish, job.finish);
    const BoardColour mask = known.solderMask.value_or(BoardColour::Green);
    const bool isPale = mask == BoardColour::White || mask == BoardColour::Yellow;
    return {mask, known.silkscreen.value_or(isPale ? BoardColour::Black : BoardColour::White),
            known.finish.value_or(SurfaceFinish::Gold)};
}

bool isFlexibleFilm(const Document& document, const Layer& layer) {
    if (layer.type == LayerType::SolderMask && layer.openings.isValid()) {
        return document.layer(layer.openings).use == LayerUse::Coverlay;
    }
    return layer.use == LayerUse::Coverlay ||
           (layer.type == LayerType::Body && isBetweenFlexibleCopper(document, layer));
}

}  // namespace model
