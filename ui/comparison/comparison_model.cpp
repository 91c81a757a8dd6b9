#include "ui/comparison/comparison_model.h"

#include <QColor>
#include <algorithm>
#include <array>

#include "model/board/diagnostic_facts.h"

namespace ui {

namespace {

using model::Accord;
using model::Comparison;

/// In the order of Accord; mid tones, readable on a light and on a dark ground; the words say the same.
constexpr QColor kAccordColours[] = {{0x4c, 0x9a, 0x5b}, {0xd9, 0x4a, 0x3d}, {0x80, 0x80, 0x80}};

QString aspectText(model::Aspect aspect) {
    const std::array<QString, model::kAspectCount> texts{
        ComparisonModel::tr("Copper"),     ComparisonModel::tr("Solder mask"), ComparisonModel::tr("Solder paste"),
        ComparisonModel::tr("Silkscreen"), ComparisonModel::tr("Outline"),     ComparisonModel::tr("Holes"),
        ComparisonModel::tr("Parts"),      ComparisonModel::tr("Pins"),        ComparisonModel::tr("Nets"),
        ComparisonModel::tr("Net names"),  ComparisonModel::tr("Stackup")};
    return texts[static_cast<std::size_t>(aspect)];
}

/// In the table: what differs comes first.
int orderOf(const Comparison& comparison) {
    constexpr int kRanks[] = {2, 0, 1};
    return kRanks[static_cast<std::size_t>(comparison.accord)];
}

QString layerText(const Comparison& comparison) {
    const QString a = QString::fromStdString(comparison.layers[0]);
    const QString b = QString::fromStdString(comparison.layers[1]);
    return a == b || b.isEmpty() ? a : a.isEmpty() ? b : QStringLiteral("%1, %2").arg(a, b);
}

/// "copper 3, holes 9"
QString countsByAspect(const model::Agreement& agreement) {
    std::array<std::size_t, model::kAspectCount> counts{};
    for (const Comparison& comparison : agreement.comparisons) {
        counts[static_cast<std::size_t>(comparison.aspect)] += comparison.differing;
    }
    QStringList texts;
    for (std::size_t aspect = 0; aspect < counts.size(); ++aspect) {
        if (counts[aspect] > 0) {
            texts += QStringLiteral("%1 %L2")
                         .arg(aspectText(static_cast<model::Aspect>(aspect)).toLower())
                         .arg(counts[aspect]);
        }
    }
    return texts.join(QStringLiteral(", "));
}

}  // namespace

ComparisonModel::ComparisonModel(QObject* parent)
    : TableModel({{tr("Aspect"), tr("What was compared")},
                  {tr("Layer"), tr("Its layer, and that of the other board where it has another name")},
                  {tr("What"), tr("How the boards differ. A is the board on the screen, B the other one")},
                  {tr("X"), tr("Where, in the coordinates of the board on the screen"), kNumber},
                  {tr("Y"), tr("Where, in the coordinates of the board on the screen"), kNumber}},
                 parent) {}

void ComparisonModel::setBoards(std::optional<ComparedBoards> boards) {
    beginResetModel();
    m_boards = std::move(boards);
    m_rows.clear();
    if (m_boards) {
        const std::vector<Comparison>& comparisons = m_boards->agreement.comparisons;
        std::vector<std::size_t> order(comparisons.size());
        std::ranges::generate(order, [i = std::size_t{0}]() mutable { return i++; });
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return orderOf(comparisons[i]); });
        std::ranges::for_each(order, [this](std::size_t i) { listComparison(i); });
    }
    endResetModel();
}

void ComparisonModel::listComparison(std::size_t comparison) {
    const Comparison& compared = m_boards->agreement.comparisons[comparison];
    for (std::size_t i = 0; i < compared.differences.size(); ++i) {
        m_rows.push_back({comparison, i});
    }
    if (compared.differences.empty() || compared.differing > compared.differences.size()) {
        m_rows.push_back({comparison, compared.differences.size()});
    }
}

const model::Difference* ComparisonModel::difference(int row) const {
    const std::vector<model::Difference>& differences = comparison(row).differences;
    const std::size_t at = m_rows[static_cast<std::size_t>(row)].difference;
    return at < differences.size() ? &differences[at] : nullptr;
}

QString ComparisonModel::summary() const {
    if (!m_boards) {
        return tr("Not compared yet");
    }
    const model::Agreement& agreement = m_boards->agreement;
    std::size_t count = 0;
    std::ranges::for_each(agreement.comparisons, [&](const Comparison& each) { count += each.differing; });
    const QString found = !agreement.isCompared() ? tr("Nothing could be compared")
                          : count == 0            ? tr("No differences")
                          : count == 1            ? tr("1 difference: %1").arg(countsByAspect(agreement))
                                                  : tr("%L1 differences: %2").arg(count).arg(countsByAspect(agreement));
    const auto isIncomplete = [](const model::Document& job) { return model::firstError(job.diagnostics) != nullptr; };
    const QString left =
        isIncomplete(*m_boards->a) || isIncomplete(*m_boards->b) ? tr(" (not all of both could be read)") : QString();
    return tr("%1%2. A is this board, B is %3").arg(found, left, m_boards->nameOfB);
}

QString ComparisonModel::whatText(int row) const {
    if (const model::Difference* const found = difference(row)) {
        return QString::fromStdString(found->text);
    }
    const Comparison& compared = comparison(row);
    const QString note = QString::fromStdString(compared.note);
    switch (compared.accord) {
        case Accord::Agree: return note.isEmpty() ? tr("the same") : tr("the same; %1").arg(note);
        case Accord::NotCompared: return note.isEmpty() ? tr("not compared") : tr("not compared: %1").arg(note);
        default: return tr("and %L1 more").arg(compared.differing - compared.differences.size());
    }
}

Cell ComparisonModel::coordinate(int row, model::Nm model::Point::*axis) const {
    const model::Difference* const found = difference(row);
    return found != nullptr && found->location ? length((*found->location).*axis) : Cell{QString()};
}

Cell ComparisonModel::cell(int row, int column) const {
    const Comparison& compared = comparison(row);
    switch (column) {
        case Aspect:
            return {.text = aspectText(compared.aspect),
                    .colour = kAccordColours[static_cast<std::size_t>(compared.accord)]};
        case Layer: return {layerText(compared)};
        case What: return {whatText(row)};
        case X: return coordinate(row, &model::Point::x);
        default: return coordinate(row, &model::Point::y);
    }
}

}  // namespace ui
