#include "ui/nets/net_model.h"

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>

#include "ui/nets/net_text.h"

namespace ui {

namespace {

constexpr std::size_t kCheckEvery = 4096;  // nets between two checks whether the result is still wanted
constexpr int kDot = 10;                   // pixels across

QImage dot(const QColor& colour) {
    QImage image(kDot, kDot, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::black);
    painter.setBrush(colour);
    painter.drawEllipse(QRectF(0.5, 0.5, kDot - 1.0, kDot - 1.0));
    return image;
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

}  // namespace

struct NetModel::Arranged {
    Rows rows;
    Groups groups;
    std::optional<model::NetGrouping> groupedBy;
    int nets = 0;
};

/// What is worked out in the background, from frozen tables alone.
struct NetModel::Task {
    std::shared_ptr<const model::Document> document;
    std::shared_ptr<const model::NetStatistics> statistics;
    Filter filter;
    std::optional<model::NetGrouping> grouping;
    Groups groups;  ///< known from before, or null
    int column = Name;
    Qt::SortOrder order = Qt::AscendingOrder;

    /// What rows are ordered by; equal ones by name.
    [[nodiscard]] double keyOf(std::uint32_t net) const {
        switch (column) {
            case Pins: return statistics->pins[net];
            case Vias: return statistics->vias[net];
            case Elements: return document->netStart[net + 1] - document->netStart[net];
            case Length: return statistics->lengthNm[net];
            case Area: return statistics->areaNm2[net];
            default: return statistics->nameRank[net];
        }
    }

    template <class IsWanted>
    [[nodiscard]] Arranged run(const IsWanted& isWanted) const {
        Arranged out;
        for (std::uint32_t net = 0; net < document->nets.size(); ++net) {
            if (net % kCheckEvery == 0 && !isWanted()) {
                return {};
            }
            if (filter.takes(document->nets[net].name)) {
                out.rows.push_back(net);
            }
        }
        out.nets = static_cast<int>(out.rows.size());
        if (grouping) {
            out.groupedBy = grouping;
            out.groups = groups ? groups : std::make_shared<model::NetGroups>(model::groupNets(*document, *grouping));
        }
        sort(out);
        if (out.groups) {
            addHeadings(out);
        }
        return out;
    }

    void sort(Arranged& out) const {
        const auto groupOf = [&](std::uint32_t net) { return out.groups ? out.groups->groupOf[net] : 0; };
        const auto rank = [&](std::uint32_t net) { return statistics ? statistics->nameRank[net] : net; };
        std::ranges::sort(out.rows, [&](std::uint32_t a, std::uint32_t b) {
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

    static void addHeadings(Arranged& out) {
        Rows rows;
        std::optional<std::uint32_t> last;
        for (const std::uint32_t net : out.rows) {
            const auto rest = static_cast<std::uint32_t>(out.groups->names.size());
            const std::uint32_t group = std::min(out.groups->groupOf[net], rest);
            if (group != last) {
                rows.push_back(kHeading | group);
                last = group;
            }
            rows.push_back(net);
        }
        out.rows = std::move(rows);
    }
};

NetModel::NetModel(QObject* parent)
    : TableModel({{tr("Net"), tr("Name in the job")},
                  {tr("Pins"), tr("Pins of components on the net"), kNumber},
                  {tr("Vias"), tr("Plated holes that join layers; not those of pins"), kNumber},
                  {tr("Elements"), tr("All elements of the net, on whatever layers"), kNumber},
                  {tr("Length"), tr("Centre lines of all tracks on copper layers, without pads"), kNumber},
                  {tr("Copper"), tr("Area of what is drawn on copper layers; overlaps count twice"), kNumber},
                  {tr("Colour"), tr("The net's own colour; a click sets or changes it"), kColour | kEditable},
                  {tr("Show"), tr("Whether the net is drawn"), kCheck}},
                 parent) {
    m_pool.setMaxThreadCount(1);
}

NetModel::~NetModel() {
    ++m_wanted;  // ends what is being worked out
    m_pool.clear();
    m_pool.waitForDone();
}

void NetModel::setNets(std::shared_ptr<const model::Document> document,
                       std::shared_ptr<const model::NetStatistics> statistics, std::uint32_t step) {
    beginResetModel();
    m_step = step;
    m_document = std::move(document);
    m_statistics = std::move(statistics);
    m_rows.clear();
    m_groups.reset();
    m_groupedBy.reset();
    m_shownNets = 0;
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
    arrange();
}

void NetModel::sort(int column, Qt::SortOrder order) {
    m_column = column;
    m_order = order;
    arrange();
}

void NetModel::arrange() {
    const std::uint64_t number = ++m_wanted;
    if (!m_document) {
        take(Arranged{}, number);
        return;
    }
    m_pool.clear();  // what has not begun is not wanted any more
    const Groups known = m_groupedBy == m_grouping ? m_groups : nullptr;
    m_pool.start(
        [this, number,
         task = Task{m_document, m_statistics, Filter(m_pattern, m_kind), m_grouping, known, m_column, m_order}] {
            const auto isWanted = [&] { return m_wanted == number; };
            Arranged out = task.run(isWanted);
            if (isWanted()) {
                QMetaObject::invokeMethod(
                    this, [this, number, out = std::move(out)]() mutable { take(std::move(out), number); },
                    Qt::QueuedConnection);
            }
        });
}

void NetModel::take(Arranged arranged, std::uint64_t number) {
    if (number != m_wanted) {
        return;
    }
    beginResetModel();
    m_rows = std::move(arranged.rows);
    m_groups = std::move(arranged.groups);
    m_groupedBy = arranged.groupedBy;
    m_shownNets = arranged.nets;
    m_shown = number;
    endResetModel();
    emit this->arranged();
}

model::NetId NetModel::netAt(int row) const {
    return isHeading(row) ? model::NetId{} : model::NetId{m_rows[static_cast<std::size_t>(row)]};
}

int NetModel::endOfGroup(int heading) const {
    const auto isHeading = [](std::uint32_t row) { return (row & kHeading) != 0; };
    return static_cast<int>(std::find_if(m_rows.begin() + heading + 1, m_rows.end(), isHeading) - m_rows.begin());
}

std::optional<int> NetModel::rowOf(model::NetId net) const {
    const auto found = std::ranges::find(m_rows, net.value);
    return found == m_rows.end() ? std::nullopt : std::optional(static_cast<int>(found - m_rows.begin()));
}

std::vector<model::BoardNet> NetModel::netsAt(int row) const {
    const int first = isHeading(row) ? row + 1 : row;
    const int end = isHeading(row) ? endOfGroup(row) : row + 1;
    std::vector<model::BoardNet> nets;
    for (int member = first; member < end; ++member) {
        nets.push_back({m_step, netAt(member)});
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

/// As ui/views/element_styles colours the net; nothing while it is not highlighted.
QVariant NetModel::dotOf(int row) const {
    const model::BoardNet net{m_step, netAt(row)};
    const auto place = std::ranges::lower_bound(m_highlighted, net);
    if (place == m_highlighted.end() || *place != net) {
        return {};
    }
    const auto number = static_cast<std::size_t>(place - m_highlighted.begin());
    return dot(QColor(ownColour(row).value_or(highlightColour(number))));
}

Cell NetModel::headingCell(int row, int column) const {
    if (column != Name) {
        return {};
    }
    const std::uint32_t group = m_rows[static_cast<std::size_t>(row)] & ~kHeading;
    const bool isRest = group == m_groups->names.size();
    const QString name = isRest ? tr("Other nets") : QString::fromStdString(m_groups->names[group]);
    return {.text = tr("%1  (%L2)").arg(name).arg(endOfGroup(row) - row - 1), .font = boldFont()};
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
        Cell name = text(m_document->nets[net].name);
        name.decoration = dotOf(row);
        return name;
    }
    if (column == Colour) {
        const std::optional<QRgb> colour = ownColour(row);
        return colour ? Cell{QColor(*colour).name(), QColor(*colour)} : Cell{};
    }
    if (!m_statistics) {
        return {.value = 0};
    }
    switch (column) {
        case Pins: return count(m_statistics->pins[net]);
        case Vias: return count(m_statistics->vias[net]);
        case Elements: return count(m_document->netStart[net + 1] - m_document->netStart[net]);
        case Length: return length(m_statistics->lengthNm[net]);
        default: return area(m_statistics->areaNm2[net]);
    }
}

QString NetModel::tip(int row, int column) const {
    if (column == Colour || column == Shown) {
        return {};
    }
    if (isHeading(row)) {
        return column == Name ? tr("Select it to highlight all nets of the group") : QString();
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
