#include "app/commands/measure_item_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/common/open_board.h"
#include "model/base/ascii.h"
#include "model/base/thickness_units.h"
#include "model/index/pin_names.h"

namespace app {

using base::Error;
using base::ErrorCode;
using base::Result;
using model::BoardIndex;
using model::Document;
using model::MeasureItem;

namespace {

constexpr const char* kForms = "net:NAME, part:NAME, pin:PART.PIN, element:NUMBER, at:X,Y[,LAYER] with units, or edge";
/// Names this unlike are no typing errors.
constexpr std::size_t kMostSlips = 3;
constexpr std::size_t kMostSuggestions = 3;

Error wrong(std::string text) {
    return {ErrorCode::BadUsage, std::move(text)};
}

/// How many letters must be changed, added or taken away.
std::size_t slipsBetween(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        row[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t corner = row[0]++;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = corner + (a[i - 1] == b[j - 1] ? 0 : 1);
            corner = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
        }
    }
    return row[b.size()];
}

/// The row whose name this is: exactly, else the only one that differs in case.
template <class NameOf>
Result<std::size_t> findNamed(const char* kind, std::string_view name, std::size_t count, const NameOf& nameOf) {
    if (name.empty()) {
        return wrong("a " + std::string(kind) + " has no name: write " + kForms);
    }
    const std::string lower = base::lowerCase(name);
    std::vector<std::size_t> alike;
    std::vector<std::pair<std::size_t, std::size_t>> suggestions;
    for (std::size_t row = 0; row < count; ++row) {
        if (nameOf(row) == name) {
            return row;
        }
        const std::string other = base::lowerCase(nameOf(row));
        if (other == lower) {
            alike.push_back(row);
        }
        const bool isBeginning = !lower.empty() && other.starts_with(lower);
        if (const std::size_t slips = isBeginning ? 1 : slipsBetween(lower, other);
            slips <= std::min(kMostSlips, lower.size() / 2 + 1)) {
            suggestions.emplace_back(slips, row);
        }
    }
    if (alike.size() == 1) {
        return alike.front();
    }
    std::ranges::sort(suggestions);
    suggestions.resize(std::min(suggestions.size(), kMostSuggestions));
    std::string text = "there is no " + std::string(kind) + " " + std::string(name);
    for (std::size_t i = 0; i < suggestions.size(); ++i) {
        text += (i == 0 ? "; did you mean " : " or ") + std::string(nameOf(suggestions[i].second));
    }
    return wrong(text + (suggestions.empty() ? "" : "?"));
}

std::optional<std::uint32_t> wholeNumber(std::string_view text) {
    std::uint32_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    return read.ec == std::errc() && read.ptr == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// A number with a unit, below 0 too.
Result<double> parseCoordinate(std::string_view text) {
    double number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string unit(read.ptr, text.data() + text.size());
    const Result<base::Nm> one = model::parseLength("1" + unit);
    const bool isOnBoard = one && std::abs(number * *one) <= base::kMaxCoordinate;  // which nan is not
    if (read.ec != std::errc() || !isOnBoard) {
        return wrong("\"" + std::string(text) +
                     "\" is no coordinate: a number with um, mm, mil or inch, at most 1.07 m");
    }
    return number * *one;
}

/// "2/net:GND" → copy 2 and "net:GND".
struct InCopy {
    std::uint32_t copy = 0;
    std::string_view text;
};

Result<InCopy> takeCopy(const BoardIndex& index, std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto copy = slash == std::string_view::npos ? std::nullopt : wholeNumber(text.substr(0, slash));
    if (!copy) {
        return InCopy{0, text};
    }
    if (*copy >= index.tree.copies.size()) {
        return wrong("there is no copy " + std::to_string(*copy) + ": the board has " +
                     std::to_string(index.tree.copies.size() - 1) + ", and 0 is the board itself");
    }
    return InCopy{*copy, text.substr(slash + 1)};
}

Result<MeasureItem> parseElement(const BoardIndex& index, const InCopy& at) {
    const auto number = wholeNumber(at.text);
    const std::size_t count = index.stepOf(at.copy).elements.size();
    if (!number || *number >= count) {
        return wrong("there is no element " + std::string(at.text) + ": they are numbered from 0 to " +
                     std::to_string(count == 0 ? 0 : count - 1));
    }
    return MeasureItem(model::BoardElement{at.copy, model::ElementId{*number}});
}

Result<std::size_t> findComponent(const Document& step, std::string_view name) {
    return findNamed("component", name, step.components.size(),
                     [&](std::size_t i) -> const std::string& { return step.components[i].refdes; });
}

Result<MeasureItem> parsePart(const BoardIndex& index, const InCopy& at) {
    ASSIGN_OR_RETURN(const std::size_t row, findComponent(index.stepOf(at.copy), at.text));
    return MeasureItem(model::PartOfCopy{at.copy, model::ComponentId{row}});
}

Result<MeasureItem> parsePin(const BoardIndex& index, const InCopy& at) {
    const std::size_t dot = at.text.rfind('.');
    if (dot == std::string_view::npos) {
        return wrong("\"" + std::string(at.text) + "\" is no pin: write PART.PIN, for example U1.3");
    }
    const Document& step = index.stepOf(at.copy);
    ASSIGN_OR_RETURN(const std::size_t part, findComponent(step, at.text.substr(0, dot)));
    std::vector<model::PinId> pins;
    for (const model::ComponentId one : model::componentsNamedAs(step, model::ComponentId{part})) {
        const model::Component& component = step.components[one.row()];
        for (std::size_t row = component.firstPin; row < component.firstPin + component.pinCount; ++row) {
            pins.emplace_back(row);
        }
    }
    ASSIGN_OR_RETURN(
        const std::size_t pin,
        findNamed(("pin of " + step.components[part].refdes + " named").c_str(), at.text.substr(dot + 1), pins.size(),
                  [&](std::size_t i) -> const std::string& { return step.text(step.pins[pins[i].row()].name); }));
    return MeasureItem(model::PinOfCopy{at.copy, pins[pin]});
}

Result<MeasureItem> parseAt(const BoardIndex& index, const InCopy& at) {
    const std::size_t first = at.text.find(',');
    const std::size_t second = first == std::string_view::npos ? first : at.text.find(',', first + 1);
    if (first == std::string_view::npos) {
        return wrong("\"" + std::string(at.text) + "\" is no location: write X,Y or X,Y,LAYER, for example 12.3mm,4mm");
    }
    ASSIGN_OR_RETURN(const double x, parseCoordinate(at.text.substr(0, first)));
    ASSIGN_OR_RETURN(const double y, parseCoordinate(at.text.substr(first + 1, second - first - 1)));
    model::Location location{{x, y}, {}};
    if (second != std::string_view::npos) {
        const std::vector<model::Layer>& layers = index.board->layers;
        ASSIGN_OR_RETURN(const std::size_t layer,
                         findNamed("layer", at.text.substr(second + 1), layers.size(),
                                   [&](std::size_t i) -> const std::string& { return layers[i].name; }));
        location.layer = model::LayerId{layer};
        RETURN_IF_ERROR(checkOnlyOne(*index.board, location.layer, layers[layer].name));
    }
    return MeasureItem(location);
}

Result<model::NetOfCopy> findNet(const BoardIndex& index, const InCopy& at) {
    const Document& step = index.stepOf(at.copy);
    ASSIGN_OR_RETURN(const std::size_t row,
                     findNamed("net", at.text, step.nets.size(),
                               [&](std::size_t i) -> const std::string& { return step.nets[i].name; }));
    return model::NetOfCopy{at.copy, model::NetId{row}};
}

Result<MeasureItem> parseNetItem(const BoardIndex& index, const InCopy& at) {
    ASSIGN_OR_RETURN(const model::NetOfCopy net, findNet(index, at));
    return MeasureItem(net);
}

struct Form {
    std::string_view prefix;
    Result<MeasureItem> (*parse)(const BoardIndex&, const InCopy&);
};
constexpr Form kParsers[] = {
    {"net:", parseNetItem}, {"part:", parsePart}, {"pin:", parsePin}, {"element:", parseElement}, {"at:", parseAt}};

}  // namespace

Result<MeasureItem> parseItem(const BoardIndex& index, std::string_view text) {
    ASSIGN_OR_RETURN(const InCopy at, takeCopy(index, text));
    if (at.text == "edge") {
        return MeasureItem(model::BoardEdge{});
    }
    for (const Form& form : kParsers) {
        if (at.text.starts_with(form.prefix)) {
            return form.parse(index, {at.copy, at.text.substr(form.prefix.size())});
        }
    }
    return wrong("\"" + std::string(text) + "\" names no item: write " + kForms);
}

Result<model::NetOfCopy> parseNet(const BoardIndex& index, std::string_view text) {
    ASSIGN_OR_RETURN(const InCopy at, takeCopy(index, text));
    return findNet(index, at);
}

}  // namespace app
