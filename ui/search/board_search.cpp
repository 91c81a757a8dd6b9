#include "ui/search/board_search.h"

#include <QRegularExpression>
#include <algorithm>
#include <functional>
#include <ranges>
#include <tuple>
#include <unordered_set>

#include "model/base/ascii.h"
#include "model/index/pin_names.h"
#include "model/nets/net_statistics.h"
#include "model/text/wildcard.h"
#include "ui/common/net_name.h"
#include "ui/layers/layer_model.h"

namespace ui {

namespace {

enum class Fit : std::uint8_t { Whole, Begins, Holds, None };

bool isSame(char inName, char inText) {
    return base::lowerAscii(inName) == inText;
}

/// Names of attributes have underscores where people type blanks.
bool isSameWord(char inName, char inText) {
    return isSame(inName, inText) || (inName == '_' && inText == ' ');
}

constexpr std::string_view kWildcards = "*?";

bool hasWildcards(std::string_view text) {
    return text.find_first_of(kWildcards) != std::string_view::npos;
}

/// How `name` fits a text that is in lower case. Names that hold * or ? themselves, as some jobs write inverted
/// signals, are found by them too.
Fit fitOf(std::string_view name, std::string_view text, bool (*isAlike)(char, char) = isSame) {
    const auto at = std::ranges::search(name, text, isAlike).begin();
    if (at == name.end()) {
        return hasWildcards(text) && model::fitsWildcard(name, text, isAlike) ? Fit::Holds : Fit::None;
    }
    return at != name.begin() ? Fit::Holds : name.size() == text.size() ? Fit::Whole : Fit::Begins;
}

bool isCalled(std::string_view name, std::string_view text) {
    const Fit fit = fitOf(name, text);
    return fit == Fit::Whole || (fit != Fit::None && hasWildcards(text));
}

struct Match {
    Fit fit = Fit::None;
    std::string_view name;  ///< in the document
    Found found;
};

bool isAttribute(const Match& match) {
    return match.found.kind == FoundKind::Attribute;
}

/// NET2 before NET10, but first what fits better, and before all else what is no attribute.
bool isBetter(const Match& a, const Match& b) {
    const auto rank = [](const Match& match) {
        return std::tuple(isAttribute(match), match.fit, match.found.kind, match.name.size());
    };
    if (rank(a) != rank(b)) {
        return rank(a) < rank(b);
    }
    if (a.name != b.name) {
        return model::isNamedBefore(a.name, b.name);
    }
    return std::tuple(a.found.step, a.found.row) < std::tuple(b.found.step, b.found.row);
}

class Matcher {
public:
    explicit Matcher(const QString& text) : m_text(base::lowerCase(text.trimmed().toStdString())) {}

    /// Of what comes next.
    void setStep(std::uint32_t step) { m_step = step; }

    template <class Table, class NameOf>
    void match(FoundKind kind, const Table& table, const NameOf& nameOf) {
        for (std::size_t row = 0; row < table.size(); ++row) {
            const std::string& name = nameOf(table[row]);
            const Fit fit = fitOf(name, m_text);
            if (fit != Fit::None) {
                m_matches.push_back({fit, name, {kind, static_cast<std::uint32_t>(row), m_step, {}}});
            }
        }
    }

    /// By the name in the job, and as people type it.
    void lookForNets(const base::Table<model::Net>& nets) {
        for (std::uint32_t row = 0; row < nets.size(); ++row) {
            const std::string& name = nets[row].name;
            const Fit typed = model::hasBraces(name) ? fitOf(model::typedName(name), m_text) : Fit::None;
            const Fit fit = std::min(fitOf(name, m_text), typed);
            if (fit != Fit::None) {
                m_matches.push_back({fit, name, {FoundKind::Net, row, m_step, {}}});
            }
        }
    }

    /// Pins are found by their component and their name.
    void lookForPins(const model::Document& board) {
        const std::size_t cut = m_text.find_last_of(".-");
        if (cut == std::string::npos || cut == 0) {
            return;
        }
        const std::string_view part = std::string_view(m_text).substr(0, cut);
        const std::string_view pin = std::string_view(m_text).substr(cut + 1);
        for (const model::Component& component : board.components) {
            if (!isCalled(component.refdes, part)) {
                continue;
            }
            std::unordered_set<std::string> seen;  // a pin of several pads is found once
            for (std::uint32_t row = component.firstPin; row < component.firstPin + component.pinCount; ++row) {
                const std::string name = model::pinName(board, model::PinId{std::size_t{row}});
                const Fit fit = fitOf(name, pin);
                const bool isIt = fit == Fit::Whole || fit == Fit::Begins || (fit == Fit::Holds && hasWildcards(pin));
                if (isIt && (name.empty() || seen.insert(name).second)) {
                    m_matches.push_back({fit, board.text(board.pins[row].name), {FoundKind::Pin, row, m_step, {}}});
                }
            }
        }
    }

    /// By value, or by name: then behind all that is called so itself.
    void lookForAttributes(const std::vector<model::AttributeValue>& attributes) {
        for (std::uint32_t row = 0; row < attributes.size(); ++row) {
            const auto& [owner, name, value, count] = attributes[row];
            const Fit byValue = fitOf(value, m_text);
            if (byValue != Fit::None) {
                m_matches.push_back({byValue, value, {FoundKind::Attribute, row, m_step, {}}});
            } else if (fitOf(name, m_text, isSameWord) != Fit::None) {
                m_matches.push_back({Fit::Holds, name, {FoundKind::Attribute, row, m_step, {}}});
            }
        }
    }

    /// The best ones, in order. A part of them is for attributes: a value like "10k" is found however many nets hold
    /// it.
    [[nodiscard]] std::vector<Found> best(std::size_t most) {
        const auto attributes = std::ranges::partition(m_matches, std::not_fn(isAttribute));
        const std::size_t reserved = std::min(most / kPartForAttributes, attributes.size());
        std::vector<Found> found;
        take({m_matches.begin(), attributes.begin()}, most - reserved, found);
        take(attributes, most - found.size(), found);
        return found;
    }

private:
    static constexpr std::size_t kPartForAttributes = 5;

    static void take(std::ranges::subrange<std::vector<Match>::iterator> matches, std::size_t most,
                     std::vector<Found>& found) {
        const auto count = static_cast<std::ptrdiff_t>(std::min(most, matches.size()));
        std::ranges::partial_sort(matches, matches.begin() + count, isBetter);
        std::transform(matches.begin(), matches.begin() + count, std::back_inserter(found),
                       [](const Match& match) { return match.found; });
    }

    std::string m_text;
    std::uint32_t m_step = 0;
    std::vector<Match> m_matches;
};

std::optional<double> nmPer(const QString& unit, LengthUnit otherwise) {
    return unit.isEmpty()                                              ? nmPer(otherwise)
           : unit == QLatin1String("mm")                               ? base::kNmPerMm
           : unit == QLatin1String("mil")                              ? base::kNmPerMil
           : unit == QLatin1String("in")                               ? base::kNmPerInch
           : unit == QLatin1String("um") || unit == QStringView(u"µm") ? std::optional(base::kNmPerUm)
                                                                       : std::nullopt;
}

constexpr std::uint32_t kDownwards = 1;  // Found::row of a location

bool isOnBoard(const model::Document& board, base::PointD nm) {
    const model::Box& box = board.board;
    return nm.x >= box.min.x && nm.x <= box.max.x && nm.y >= box.min.y && nm.y <= box.max.y;
}

QString counted(std::size_t count, const QString& one, const QString& many) {
    return count == 1 ? one : many.arg(count);
}

QString ownersOf(const model::AttributeValue& attribute) {
    return attribute.owner == model::AttributeValue::Owner::Components
               ? counted(attribute.count, BoardSearch::tr("Attribute of 1 component"),
                         BoardSearch::tr("Attribute of %L1 components"))
               : counted(attribute.count, BoardSearch::tr("Attribute of 1 element"),
                         BoardSearch::tr("Attribute of %L1 elements"));
}

/// What the job calls the text that elements draw.
constexpr std::string_view kDrawnText = ".string";

/// Texts on the board that are only names of its components and pins, which are found themselves: the silkscreen says
/// R12 of R12.
void leaveOutNames(const model::Document& step, std::vector<model::AttributeValue>& attributes) {
    const auto isText = [](const model::AttributeValue& attribute) { return attribute.name == kDrawnText; };
    if (std::ranges::none_of(attributes, isText)) {
        return;
    }
    std::unordered_set<std::string> names;
    for (const model::Component& component : step.components) {
        names.insert(component.refdes);
    }
    for (std::size_t row = 0; row < step.pins.size(); ++row) {
        names.insert(model::fullPinName(step, model::PinId{row}));
    }
    std::erase_if(attributes, [&](const model::AttributeValue& attribute) {
        return isText(attribute) && names.contains(attribute.value);
    });
}

}  // namespace

std::optional<base::PointD> parsePlace(const QString& text, LengthUnit unit) {
    static const QRegularExpression kPlace(
        QStringLiteral(R"(^\s*([-+]?\d*\.?\d+)\s*([a-zµ]*)\s*[, ;]\s*([-+]?\d*\.?\d+)\s*([a-zµ]*)\s*$)"),
        QRegularExpression::CaseInsensitiveOption);
    const QRegularExpressionMatch match = kPlace.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    const QString last = match.captured(4).toLower();
    const QString first = match.captured(2).isEmpty() ? last : match.captured(2).toLower();
    const std::optional<double> nmX = nmPer(first, unit);
    const std::optional<double> nmY = nmPer(last, unit);
    if (!nmX || !nmY) {
        return std::nullopt;
    }
    return base::PointD{match.captured(1).toDouble() * *nmX, match.captured(3).toDouble() * *nmY};
}

void BoardSearch::setBoard(std::shared_ptr<const model::Document> board) {
    m_board = std::move(board);
    m_steps = m_board ? model::distinctSteps(*m_board) : std::vector<const model::Document*>();
    const auto list = [board = m_board, steps = m_steps] {
        AttributesOfSteps attributes;
        for (const model::Document* step : steps) {
            leaveOutNames(*step, attributes.emplace_back(model::listAttributes(*step)));
        }
        return attributes;
    };
    m_attributes = m_board ? std::async(list).share() : std::shared_future<AttributesOfSteps>();
}

std::vector<Found> BoardSearch::find(const QString& text, LengthUnit unit, std::size_t most) const {
    if (!m_board || text.trimmed().isEmpty()) {
        return {};
    }
    Matcher matcher(text);
    matcher.match(FoundKind::Layer, m_board->layers,
                  [](const model::Layer& layer) -> const std::string& { return layer.name; });
    for (std::uint32_t row = 0; row < m_steps.size(); ++row) {
        const model::Document& step = *m_steps[row];
        matcher.setStep(row);
        matcher.match(FoundKind::Component, step.components,
                      [](const model::Component& component) -> const std::string& { return component.refdes; });
        matcher.lookForNets(step.nets);
        matcher.lookForPins(step);
        matcher.lookForAttributes(m_attributes.get()[row]);
    }
    std::vector<Found> found = matcher.best(most);
    if (const std::optional<base::PointD> location = parsePlace(text, unit)) {
        found.insert(found.begin(), {FoundKind::Location, 0, 0, *location});
        if (const base::PointD mirrored{location->x, -location->y};
            !isOnBoard(*m_board, *location) && isOnBoard(*m_board, mirrored)) {
            found.insert(found.begin(), {FoundKind::Location, kDownwards, 0, mirrored});
        }
    }
    return found;
}

QString BoardSearch::titleOf(const Found& found, LengthUnit unit) const {
    switch (found.kind) {
        case FoundKind::Location: return positionText(found.location.x, found.location.y, unit);
        case FoundKind::Layer: return QString::fromStdString(m_board->layers[found.row].name);
        case FoundKind::Component: return QString::fromStdString(stepOf(found).components[found.row].refdes);
        case FoundKind::Net: return netName(stepOf(found), model::NetId{std::size_t{found.row}});
        case FoundKind::Pin:
            return QString::fromStdString(model::fullPinName(stepOf(found), model::PinId{std::size_t{found.row}}));
        case FoundKind::Attribute: {
            const model::AttributeValue& value = attribute(found);
            return QString::fromStdString(value.value.empty() ? value.name : value.name + ": " + value.value);
        }
    }
    return {};
}

QString BoardSearch::detailOf(const Found& found) const {
    return found.step == 0
               ? whatIs(found)
               : BoardSearch::tr("%1, in step %2").arg(whatIs(found), QString::fromStdString(stepOf(found).job.step));
}

QString BoardSearch::whatIs(const Found& found) const {
    switch (found.kind) {
        case FoundKind::Location:
            return found.row == kDownwards ? BoardSearch::tr("Location, with Y counted downwards, as KiCad does")
                                           : BoardSearch::tr("Location");
        case FoundKind::Layer: return BoardSearch::tr("Layer, %1").arg(layerTypeText(m_board->layers[found.row].type));
        case FoundKind::Component: {
            const model::Component& part = stepOf(found).components[found.row];
            return BoardSearch::tr("Component, %1, %2 side, %3")
                .arg(counted(part.pinCount, BoardSearch::tr("1 pin"), BoardSearch::tr("%L1 pins")),
                     QLatin1String(model::toString(part.side)), QString::fromStdString(part.part));
        }
        case FoundKind::Pin: {
            const model::NetId net = stepOf(found).pins[found.row].net;
            const QString pin = net.isValid() ? BoardSearch::tr("Pin, net %1").arg(netName(stepOf(found), net))
                                              : BoardSearch::tr("Pin without a net");
            const std::size_t pads = model::pinsNamedAs(stepOf(found), model::PinId{std::size_t{found.row}}).size();
            return pads > 1 ? BoardSearch::tr("%1, %2 pads").arg(pin).arg(pads) : pin;
        }
        case FoundKind::Net:
            return counted(stepOf(found).elementsOf(model::NetId{std::size_t{found.row}}).size(),
                           BoardSearch::tr("Net, 1 element"), BoardSearch::tr("Net, %L1 elements"));
        case FoundKind::Attribute: return ownersOf(attribute(found));
    }
    return {};
}

}  // namespace ui
