#include "ui/nets/net_model.h"

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>

#include "model/text/net_names.h"
#include "ui/nets/net_text.h"

namespace ui {

namespace {

constexpr std::size_t kCheckEvery = 4096;  // nets between two checks whether the result is still wanted
constexpr int kSign = 10;                  // pixels across
constexpr int kIndentation = 12;           // pixels for each heading that a row stands under

/// What stands before a name: room for its depth, and behind it a sign, if any, that `draw` draws into a square.
template <class Draw>
QImage before(int depth, bool hasSign, const Draw& draw) {
    QImage image(std::max(depth * kIndentation + (hasSign ? kSign : 0), 1), kSign, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(depth * kIndentation, 0);
    if (hasSign) {
        draw(painter);
    }
    return image;
}

QImage dot(int depth, const std::optional<QRgb>& colour) {
    return before(depth, colour.has_value(), [&](QPainter& painter) {
        painter.setPen(Qt::black);
        painter.setBrush(QColor(*colour));
        painter.drawEllipse(QRectF(0.5, 0.5, kSign - 1.0, kSign - 1.0));
    });
}

QImage triangle(int depth, bool isFolded) {
    return before(depth, true, [&](QPainter& painter) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(Qt::gray);  // on light and on dark ground
        painter.drawPolygon(isFolded ? QPolygonF({{2, 1}, {8, 5}, {2, 9}}) : QPolygonF({{1, 2}, {9, 2}, {5, 8}}));
    });
}

/// Decides on names; made once per filter.
class Filter {
public:
    Filter(const QString& pattern, NetModel::FilterKind kind) {
        if (kind == NetModel::FilterKind::Text) {
            for (const QString& word : pattern.toLower().split(' ', Qt::SkipEmptyParts)) {
                m_words.push_back(word.toStdString());
            }
            return;
        }
        const QString text =
            kind == NetModel::FilterKind::Wildcard ? QRegularExpression::wildcardToRegularExpression(pattern) : pattern;
        if (!pattern.isEmpty()) {
            m_expression.emplace(text, QRegularExpression::CaseInsensitiveOption);
        }
    }

    [[nodiscard]] bool isValid() const { return !m_expression || m_expression->isValid(); }
    [[nodiscard]] bool takes(const std::string& name) const {
        if (m_expression) {
            return m_expression->match(QString::fromStdString(name)).hasMatch();
        }
        return std::ranges::all_of(m_words, [&](const std::string& word) { return contains(name, word); });
    }

private:
    static bool contains(const std::string& name, const std::string& word) {
        const auto same = [](char a, char b) {
            return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + ('a' - 'A')) : a) == b;
        };
        return std::search(name.begin(), name.end(), word.begin(), word.end(), same) != name.end();
    }

    std::vector<std::string> m_words;
    std::optional<QRegularExpression> m_expression;
};

double keyOf(const model::Document& document, const model::NetStatistics& statistics, int column, std::uint32_t net) {
    switch (column) {
        case NetModel::Pins: return statistics.pins[net];
        case NetModel::Vias: return statistics.vias[net];
        case NetModel::Elements: return document.netStart[net + 1] - document.netStart[net];
        case NetModel::Length: return statistics.lengthNm[net];
        case NetModel::Area: return statistics.areaNm2[net];
        default: return statistics.nameRank[net];
    }
}

QString countText(std::size_t nets) {
    return nets == 1 ? NetModel::tr("1 net") : NetModel::tr("%L1 nets").arg(nets);
}

}  // namespace

/// What is worked out in the background, from frozen tables alone.
struct NetModel::Task {
    std::shared_ptr<const model::Document> document;
    std::shared_ptr<const model::NetStatistics> statistics;
    Filter filter;
    std::optional<model::NetGrouping> grouping;
    NetRows::Groups groups;  ///< known from before, or null
    int column = Name;
    Qt::SortOrder order = Qt::AscendingOrder;

    /// What rows are ordered by; equal ones by name.
    [[nodiscard]] double keyOf(std::uint32_t net) const { return ui::keyOf(*document, *statistics, column, net); }

    [[nodiscard]] Arranged run(const base::Progress& progress) const {
        std::vector<std::uint32_t> nets;
        for (std::uint32_t net = 0; net < document->nets.size(); ++net) {
            if (net % kCheckEvery == 0 && progress.isCancelled()) {
                return {};
            }
            const std::string& name = document->nets[net].name;
            if (filter.takes(name) || (model::hasBraces(name) && filter.takes(model::typedName(name)))) {
                nets.push_back(net);
            }
        }
        if (progress.isCancelled()) {
            return {};
        }
        const NetRows::Groups known =
            grouping && !groups ? std::make_shared<model::NetGroups>(model::groupNets(*document, *grouping)) : groups;
        sort(nets, known.get());
        return {NetRows(nets, known), grouping};
    }

    void sort(std::vector<std::uint32_t>& nets, const model::NetGroups* by) const {
        const auto groupOf = [&](std::uint32_t net) { return by != nullptr ? by->groupOf[net] : 0; };
        const auto rank = [&](std::uint32_t net) { return statistics ? statistics->nameRank[net] : net; };
        std::ranges::sort(nets, [&](std::uint32_t a, std::uint32_t b) {
            if (groupOf(a) != groupOf(b)) {
                return groupOf(a) < groupOf(b);
            }
            const double ka = statistics ? keyOf(a) : 0.0;
            const double kb = statistics ? keyOf(b) : 0.0;
            if (ka != kb) {
                return order == Qt::AscendingOrder ? ka < kb : ka > kb;
            }
            return rank(a) < rank(b);
        });
    }
};

NetModel::NetModel(QObject* parent)
    : TableModel({{tr("Net"), tr("Name of the net")},
                  {tr("Pins"), tr("Pins of components on the net"), kNumber},
                  {tr("Vias"), tr("Plated holes that join layers; not those of pins"), kNumber},
                  {tr("Elements"), tr("All elements of the net, on whatever layers"), kNumber},
                  {tr("Length"), tr("Centre lines of all tracks on copper layers, without pads"), kNumber},
                  {tr("Copper"), tr("Area of what is drawn on copper layers; overlaps count twice"), kNumber},
                  {tr("Colour"), tr("The net's own colour; a click sets or changes it"), kColour | kEditable},
                  {tr("Show"), tr("Whether the net is drawn"), kCheck}},
                 parent) {
    connect(&m_work.background(), &Background::finished, this, &NetModel::deliver);
}

void NetModel::setNets(std::shared_ptr<const model::Document> document,
                       std::shared_ptr<const model::NetStatistics> statistics, std::uint32_t step) {
    beginResetModel();
    m_step = step;
    m_document = std::move(document);
    m_statistics = std::move(statistics);
    m_rows = {};
    m_groupedBy.reset();
    m_folded.clear();
    endResetModel();
    arrange();
}

void NetModel::setStyles(NetStyles& styles) {
    m_styles = &styles;
    connect(&styles, &NetStyles::changed, this, &NetModel::announceChange);
}

void NetModel::setHighlighted(std::vector<model::BoardNet> nets) {
    m_highlighted = std::move(nets);
    announceChange();
}

bool NetModel::setFilter(const QString& pattern, FilterKind kind) {
    const bool isValid = Filter(pattern, kind).isValid();
    m_pattern = isValid ? pattern : QString();
    m_kind = kind;
    arrange();
    return isValid;
}

void NetModel::setGrouping(std::optional<model::NetGrouping> grouping) {
    m_grouping = grouping;
    m_folded.clear();
    arrange();
}

void NetModel::fold(int heading, bool isFolded) {
    beginResetModel();
    m_rows.fold(heading, isFolded);
    m_folded = m_pattern.isEmpty() ? m_rows.folded() : m_folded;
    endResetModel();
    emit arranged();
}

void NetModel::reveal(model::NetId net) {
    if (m_rows.groups() && !m_rows.rowOf(net)) {
        beginResetModel();
        m_rows.reveal(net);
        m_folded = m_pattern.isEmpty() ? m_rows.folded() : m_folded;
        endResetModel();
        emit arranged();
    }
}

void NetModel::sort(int column, Qt::SortOrder order) {
    m_column = column;
    m_order = order;
    arrange();
}

void NetModel::arrange() {
    if (!m_document) {
        m_work.cancel();
        take({});
        return;
    }
    const NetRows::Groups known = m_groupedBy == m_grouping ? m_rows.groups() : nullptr;
    m_work.run([task = Task{m_document, m_statistics, Filter(m_pattern, m_kind), m_grouping, known, m_column, m_order}](
                   base::Progress& progress) { return task.run(progress); },
               tr("Listing the nets"), tr("There is not enough memory to list the nets."));
}

void NetModel::deliver() {
    base::Result<Arranged> arranged = m_work.take();
    if (!arranged) {
        emit failed(QString::fromStdString(arranged.error().text));
    }
    take(arranged ? std::move(*arranged) : Arranged());
}

void NetModel::take(Arranged arranged) {
    beginResetModel();
    m_rows = std::move(arranged.rows);
    if (m_rows.groups() && m_pattern.isEmpty()) {
        m_rows.setFolded(m_folded);
    }
    m_groupedBy = arranged.groupedBy;
    endResetModel();
    emit this->arranged();
}

std::vector<model::BoardNet> NetModel::netsAt(int row) const {
    std::vector<model::BoardNet> nets;
    for (const model::NetId net : m_rows.netsAt(row)) {
        nets.push_back({m_step, net});
    }
    return nets;
}

bool NetModel::isAnyHidden(int row) const {
    return m_styles != nullptr && !m_styles->state().empty() &&
           std::ranges::any_of(netsAt(row), [&](const model::BoardNet& net) { return m_styles->isHidden(net); });
}

std::optional<QRgb> NetModel::ownColour(int row) const {
    return m_styles != nullptr ? m_styles->of({m_step, netAt(row)}).colour : std::nullopt;
}

/// As ui/views/element_styles colours the net; none while it is not highlighted.
std::optional<QRgb> NetModel::highlightOf(int row) const {
    const model::BoardNet net{m_step, netAt(row)};
    const auto place = std::ranges::lower_bound(m_highlighted, net);
    if (place == m_highlighted.end() || *place != net) {
        return std::nullopt;
    }
    const auto number = static_cast<std::size_t>(place - m_highlighted.begin());
    return ownColour(row).value_or(highlightColour(number));
}

QString NetModel::headingText(int row) const {
    const std::vector<std::string>& groups = m_rows.groups()->names;
    const std::uint32_t group = m_rows.groupAt(row);
    const QString rest = m_groupedBy == model::NetGrouping::Sheet ? tr("Nets of all sheets") : tr("Other nets");
    return group == groups.size() ? rest : QString::fromStdString(model::readableName(groups[group]));
}

/// How many nets it has stands beside the name, which needs all the room of its column.
Cell NetModel::headingCell(int row, int column) const {
    if (column == Length) {
        return {.text = countText(m_rows.netCountAt(row))};
    }
    if (column != Name) {
        return {};
    }
    return {.text = headingText(row),
            .decoration = triangle(m_rows.depthOf(row), m_rows.isFolded(row)),
            .font = boldFont()};
}

Cell NetModel::nameCell(int row) const {
    const std::string& name = m_document->nets[netAt(row).row()].name;
    const bool isInSheet = m_groupedBy == model::NetGrouping::Sheet;
    const std::string shown = isInSheet ? name.substr(model::sheetOf(name, m_rows.groups()->backslash).size()) : name;
    const std::optional<QRgb> highlight = highlightOf(row);
    const int depth = m_rows.depthOf(row);
    return {.text = QString::fromStdString(model::readableName(shown)),
            .value = QString::fromStdString(model::readableName(name)),
            .decoration = depth > 0 || highlight ? QVariant(dot(depth, highlight)) : QVariant()};
}

Cell NetModel::cell(int row, int column) const {
    if (column == Shown) {
        return {.isChecked = !isAnyHidden(row)};
    }
    if (isHeading(row)) {
        return headingCell(row, column);
    }
    const std::size_t net = netAt(row).row();
    if (column == Name) {
        return nameCell(row);
    }
    if (column == Colour) {
        const std::optional<QRgb> colour = ownColour(row);
        return colour ? Cell{QColor(*colour).name(), QColor(*colour)} : Cell{};
    }
    return m_statistics ? numberCell(net, column) : Cell{.value = 0};
}

Cell NetModel::numberCell(std::size_t net, int column) const {
    switch (column) {
        case Pins: return count(m_statistics->pins[net]);
        case Vias: return count(m_statistics->vias[net]);
        case Elements: return count(m_document->netStart[net + 1] - m_document->netStart[net]);
        case Length: return length(m_statistics->lengthNm[net]);
        default: return area(m_statistics->areaNm2[net]);
    }
}

QStringList NetModel::widestTexts(Column column) const {
    const auto count = m_document && m_statistics ? static_cast<std::uint32_t>(m_document->nets.size()) : 0;
    if (count == 0) {
        return {};
    }
    std::uint32_t largest = 0;
    for (std::uint32_t net = 1; net < count; ++net) {
        const auto key = [&](std::uint32_t of) { return keyOf(*m_document, *m_statistics, column, of); };
        largest = key(net) > key(largest) ? net : largest;
    }
    QStringList texts{numberCell(largest, column).text.toString()};
    if (column == Length) {
        texts += countText(count);
    }
    return texts;
}

QString NetModel::tip(int row, int column) const {
    if (column == Colour || column == Shown) {
        return {};
    }
    if (isHeading(row)) {
        return column == Name ? tr("%1, %2\nSelect it to highlight all nets of the group; its triangle, or Left and "
                                   "Right, fold it")
                                    .arg(headingText(row), countText(m_rows.netCountAt(row)))
                              : QString();
    }
    const model::NetId net = netAt(row);
    return netsText(*m_document, m_statistics.get(), std::span(&net, 1), unit());
}

bool NetModel::check(int row, int, bool isChecked) {
    if (m_styles != nullptr) {
        m_styles->hide(netsAt(row), !isChecked);
    }
    return m_styles != nullptr;
}

bool NetModel::edit(int row, int, const QVariant& value) {
    const auto colour = value.value<QColor>();
    if (m_styles != nullptr) {
        m_styles->colour(netsAt(row), colour.isValid() ? std::optional(colour.rgb()) : std::nullopt);
    }
    return m_styles != nullptr;
}

}  // namespace ui
