#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/board/copies.h"
#include "model/nets/net_statistics.h"
#include "ui/common/table_model.h"
#include "ui/nets/net_rows.h"
#include "ui/nets/net_styles.h"
#include "ui/workspace/background_result.h"

namespace ui {

/// The nets of a board or of a step it places, filtered, sorted and under headings of groups if requested. All that
/// runs in the background, so that the window stays usable with a million nets: until it is done the rows stay as they
/// were. Under the headings of sheets a name is what it is within its sheet.
class NetModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Name, Pins, Vias, Elements, Length, Area, Colour, Shown };
    enum class FilterKind { Text, Wildcard, Regex };

    explicit NetModel(QObject* parent = nullptr);

    /// `statistics` may be null: then the numbers are 0 and names are in the order of the job. `step` is the row of the
    /// document in model::StepTree::steps.
    void setNets(std::shared_ptr<const model::Document> document,
                 std::shared_ptr<const model::NetStatistics> statistics, std::uint32_t step = 0);
    /// Colours and whether nets are shown: read here, and requested where a cell is edited.
    void setStyles(NetStyles& styles);
    /// Each has a dot before its name in the colour that it is drawn in; in rising order.
    void setHighlighted(std::vector<model::BoardNet> nets);
    /// Case does not matter. Several words of a text must all be in the name; a wildcard has * and ? and fits the whole
    /// name. False if a regular expression is not one: then all nets are shown.
    bool setFilter(const QString& pattern, FilterKind kind);
    /// Groups come in the order people count, each under a heading, what is in none of them last.
    void setGrouping(std::optional<model::NetGrouping> grouping);
    /// Folds the group of a heading, or unfolds it. While there is a filter nothing is folded.
    void fold(int heading, bool isFolded);
    /// Unfolds what a net is folded away in.
    void reveal(model::NetId net);
    /// Filter and order have been worked out for the last request.
    [[nodiscard]] bool isArranged() const { return !m_work.isRunning(); }

    /// Headings, what lies within what, what is folded.
    [[nodiscard]] const NetRows& arrangement() const { return m_rows; }
    [[nodiscard]] bool isHeading(int row) const { return m_rows.isHeading(row); }
    /// None for headings.
    [[nodiscard]] model::NetId netAt(int row) const { return m_rows.netAt(row); }
    /// The net of a row, or all under a heading.
    [[nodiscard]] std::vector<model::BoardNet> netsAt(int row) const;
    [[nodiscard]] std::size_t netCountAt(int row) const { return m_rows.netCountAt(row); }
    [[nodiscard]] std::uint32_t step() const { return m_step; }
    /// Nets that the filter takes.
    [[nodiscard]] int shown() const { return m_rows.nets(); }
    /// None if the filter hides it or it is folded away.
    [[nodiscard]] std::optional<int> rowOf(model::NetId net) const { return m_rows.rowOf(net); }
    [[nodiscard]] int total() const { return m_document ? static_cast<int>(m_document->nets.size()) : 0; }

    /// What a column of numbers needs room for: the text of the largest number of all nets, and of Length what the
    /// heading of all of them would say. Empty where there are none.
    [[nodiscard]] QStringList widestTexts(Column column) const;

    void sort(int column, Qt::SortOrder order) override;

signals:
    /// The rows are those of the last request.
    void arranged();
    /// There are no rows.
    void failed(const QString& reason);

private:
    struct Task;
    struct Arranged {
        NetRows rows;
        std::optional<model::NetGrouping> groupedBy;
    };

    void arrange();
    void deliver();
    void take(Arranged arranged);
    [[nodiscard]] int rows() const override { return m_rows.count(); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString headingText(int row) const;
    [[nodiscard]] Cell headingCell(int row, int column) const;
    [[nodiscard]] Cell nameCell(int row) const;
    [[nodiscard]] Cell numberCell(std::size_t net, int column) const;
    [[nodiscard]] bool isAnyHidden(int row) const;
    [[nodiscard]] std::optional<QRgb> ownColour(int row) const;
    [[nodiscard]] std::optional<QRgb> highlightOf(int row) const;
    [[nodiscard]] QString tip(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;
    bool check(int row, int column, bool isChecked) override;

    std::shared_ptr<const model::Document> m_document;
    std::shared_ptr<const model::NetStatistics> m_statistics;
    NetStyles* m_styles = nullptr;
    std::vector<model::BoardNet> m_highlighted;
    std::uint32_t m_step = 0;
    QString m_pattern;
    FilterKind m_kind = FilterKind::Text;
    int m_column = Name;
    Qt::SortOrder m_order = Qt::AscendingOrder;
    std::optional<model::NetGrouping> m_grouping;
    NetRows m_rows;
    std::optional<model::NetGrouping> m_groupedBy;  ///< those of the rows
    std::vector<bool> m_folded;                     ///< of the rows without a filter
    BackgroundResult<Arranged> m_work;
};

}  // namespace ui
