#include "ui/clearance/clearance_model.h"

#include <QColor>
#include <algorithm>
#include <tuple>
#include <utility>

namespace ui {

namespace {

/// With the reason where the spacing does not say it.
std::string titleOf(const model::Rule& rule, const model::RuleFinding& found) {
    const std::string reason = model::reasonOf(found);
    return model::titleOf(rule) + (reason.empty() ? "" : ": " + reason);
}

}  // namespace

ClearanceModel::ClearanceModel(QObject* parent)
    : TableModel({{tr("Rule"), tr("The rule that is broken there")},
                  {tr("Waived"), tr("Why it is no failure, and who says so")},
                  {tr("First"), tr("The one side: net, pin, what it is, and the number of its element")},
                  {tr("Second"), tr("The other side: net, pin, what it is, and the number of its element")},
                  {tr("Spacing"), tr("How far apart, or how wide; 0: they touch or overlap"), kNumber},
                  {tr("Required"), tr("The least value that passes"), kNumber},
                  {tr("Layer"), tr("Where it is")},
                  {tr("X"), tr("Where it is, in the coordinates of the step"), kNumber},
                  {tr("Y"), tr("Where it is, in the coordinates of the step"), kNumber},
                  {tr("Step"), tr("The step it is on; seen in all its copies")}},
                 parent) {}

void ClearanceModel::setSpacings(std::shared_ptr<const model::Document> board, std::vector<StepSpacings> spacings,
                                 model::RuleTable rules, bool isComplete, bool isCut) {
    beginResetModel();
    setBoard(std::move(board));
    m_shownRule.reset();
    m_rules = std::move(rules);
    m_isComplete = isComplete;
    m_isCut = isCut;
    m_names.assign(m_tree.steps.size(), nullptr);
    for (const StepSpacings& step : spacings) {
        const auto at = std::ranges::find_if(m_tree.steps, [&](const auto& known) { return &*known == step.step; });
        const auto row = static_cast<std::uint32_t>(at - m_tree.steps.begin());
        m_names[row] = step.names;
        for (const model::RuleFinding& found : step.locations) {
            m_locations.push_back({row, found});
        }
        for (const model::WaivedFinding& waived : step.waived) {
            m_locations.push_back({row, waived.found, waived.waiver, waived.reason});
        }
    }
    std::ranges::stable_sort(m_locations, {}, [](const Location& p) {
        return std::tuple(p.waiver.has_value(), p.found.rule, p.found.spacing.distance);
    });
    endResetModel();
}

void ClearanceModel::setBoard(std::shared_ptr<const model::Document> board) {
    m_board = std::move(board);
    m_tree = m_board ? model::unfoldCopies(*m_board) : model::StepTree{};
    m_locations.clear();
}

void ClearanceModel::setThroughStackup(std::shared_ptr<const model::Document> board,
                                       std::span<const model::StackupClearance> clearances,
                                       std::vector<std::shared_ptr<const model::SideNames>> names, bool isCut) {
    beginResetModel();
    setBoard(std::move(board));
    m_shownRule.reset();
    m_rules = {};
    m_isComplete = true;
    m_isCut = isCut;
    m_names = std::move(names);
    for (const model::StackupClearance& found : clearances) {
        const model::RuleFinding plain{0, found.layerA, found.a.element, found.b.element, found.spacing};
        m_locations.push_back({.step = stepOf(found.a), .found = plain, .throughStackup = found});
    }
    endResetModel();
}

QString ClearanceModel::summary() const {
    if (!m_board) {
        return tr("No search yet");
    }
    if (m_rules.rules.empty()) {
        return found();
    }
    // The verdict comes first: a narrow panel cuts the end.
    const QString verdict = m_shownRule ? tr("%1; %2").arg(found(), shownText()) : found();
    return tr("%1; tolerance of limits %2").arg(verdict, lengthText(static_cast<double>(m_rules.tolerance), unit()));
}

QString ClearanceModel::shownText() const {
    const auto shown = std::ranges::count(m_locations, *m_shownRule, [](const Location& p) { return p.found.rule; });
    return tr("shown: %L1 of %L2, of “%3” alone")
        .arg(shown)
        .arg(m_locations.size())
        .arg(QString::fromStdString(model::titleOf(m_rules.rules[*m_shownRule])));
}

void ClearanceModel::showRule(std::optional<std::size_t> rule) {
    m_shownRule = rule && *rule < m_rules.rules.size() ? rule : std::nullopt;
}

int ClearanceModel::rankOf(int row) const {
    const bool isOfOther = m_shownRule && location(row).found.rule != *m_shownRule;
    return isOfOther ? -1 : location(row).waiver ? 0 : 1;
}

QString ClearanceModel::found() const {
    const auto waived = std::ranges::partition_point(m_locations, [](const Location& p) { return !p.waiver; });
    const std::span counted(m_locations.begin(), waived);
    const auto rest = m_locations.end() - waived;
    return rest == 0 ? foundOf(counted) : tr("%1; %L2 waived").arg(foundOf(counted)).arg(rest);
}

QString ClearanceModel::foundOf(std::span<const Location> locations) const {
    if (locations.empty()) {
        return m_rules.rules.empty() ? tr("Nothing found")
               : m_isComplete        ? tr("All rules pass")
                                     : tr("No rule is broken, but not everything could be checked");
    }
    if (!m_rules.rules.empty()) {  // a smallest value of widths, rings and spacings would say nothing
        return (m_isCut                 ? tr("FAIL: at least %L1 locations break a rule")
                : locations.size() == 1 ? tr("FAIL: %L1 location breaks a rule")
                                        : tr("FAIL: %L1 locations break a rule"))
            .arg(locations.size());
    }
    const auto smallest =
        std::ranges::min_element(locations, {}, [](const Location& p) { return p.found.spacing.distance; });
    const QString spacing = lengthText(smallest->found.spacing.distance, unit());
    if (locations.size() == 1) {
        return tr("1 location, spacing %1").arg(spacing);
    }
    // What is looked for comes first: a narrow panel has no room for all of it.
    const QString text =
        m_isCut ? tr("Smallest spacing %1; at least %L2 locations") : tr("Smallest spacing %1; %L2 locations");
    return text.arg(spacing).arg(locations.size());
}

int ClearanceModel::rowOf(const Location& location) const {
    const auto key = [](const Location& p) {
        return std::tuple(p.step, p.found.rule, p.found.layer, p.found.a, p.found.b);
    };
    const auto at = std::ranges::find(m_locations, key(location), key);
    return at == m_locations.end() ? -1 : static_cast<int>(at - m_locations.begin());
}

int ClearanceModel::firstOf(std::size_t rule) const {
    const auto at = std::ranges::find_if(m_locations, [&](const Location& p) { return p.found.rule == rule; });
    return isOfRules() && at != m_locations.end() ? static_cast<int>(at - m_locations.begin()) : -1;
}

model::Waiver ClearanceModel::waiverFor(int row) const {
    const Location& at = location(row);
    return model::waiverOf(*m_tree.steps[at.step], *m_names[at.step], m_rules, at.found, {});
}

Cell ClearanceModel::cell(int row, int column) const {
    Cell cell = plainCell(row, column);
    if (location(row).waiver) {
        cell.colour = QColor(Qt::gray);
    }
    return cell;
}

/// Of both sides.
Cell ClearanceModel::stackupCell(const model::StackupClearance& found, int column) const {
    const std::string& first = m_board->layer(found.layerA).name;
    const std::string& second = m_board->layer(found.layerB).name;
    const auto sideOf = [&](const model::BoardElement& at) {
        const std::string copy = m_tree.copies.size() == 1 ? "" : "copy " + std::to_string(at.copy) + ": ";
        return text(copy + model::textOf(m_names[stepOf(at)]->of(at.element)));
    };
    switch (column) {
        case Layer: return text(first == second ? first : first + ", " + second);
        case First: return sideOf(found.a);
        default: return sideOf(found.b);
    }
}

/// Some rules allow nothing at all, and have no least value.
Cell ClearanceModel::requiredCell(const model::RuleFinding& found) const {
    const double least = m_rules.rules.empty() ? 0.0 : model::requiredOf(m_rules.rules[found.rule], found);
    return least > 0 ? length(least) : Cell{QString()};
}

Cell ClearanceModel::plainCell(int row, int column) const {
    const model::RuleFinding& found = location(row).found;
    const model::Document& step = *m_tree.steps[location(row).step];
    const auto& through = location(row).throughStackup;
    if (through && (column == First || column == Second || column == Layer)) {
        return stackupCell(*through, column);
    }
    switch (column) {
        case Rule: return m_rules.rules.empty() ? Cell{QString()} : text(titleOf(m_rules.rules[found.rule], found));
        case Waived: return text(location(row).reason);
        case First: return text(model::textOf(m_names[location(row).step]->of(found).first));
        case Second: return text(model::textOf(m_names[location(row).step]->of(found).second));
        case Spacing: return length(found.spacing.distance);
        case Required: return requiredCell(found);
        case Layer: return text(step.layer(found.layer).name);
        case X: return length(found.spacing.from.x);
        case Y: return length(found.spacing.from.y);
        default: return text(step.job.step);
    }
}

}  // namespace ui
