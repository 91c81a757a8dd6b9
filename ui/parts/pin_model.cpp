#include "ui/parts/pin_model.h"

#include <algorithm>

#include "model/index/pin_names.h"
#include "model/nets/net_statistics.h"
#include "ui/common/net_name.h"

namespace ui {

namespace {

/// Of one type, or cells do not compare; what has no place comes first.
QVariant place(std::optional<std::size_t> rank) {
    return rank ? QVariant(static_cast<qlonglong>(*rank)) : QVariant(qlonglong{-1});
}

}  // namespace

PinModel::PinModel(QObject* parent)
    : TableModel({{tr("Pin"), tr("Designator of the component and name of the pin")},
                  {tr("Net"), tr("The net the pin is on")},
                  {tr("Layer"), tr("Copper layers of its pads and hole")},
                  {tr("X"), tr("Position in the coordinates of the step"), kNumber | kLength},
                  {tr("Y"), tr("Position in the coordinates of the step"), kNumber | kLength},
                  {tr("Step"), tr("The step it is on; seen in all its copies")}},
                 parent) {}

std::span<const model::Document* const> PinModel::steps() const {
    return m_board ? std::span<const model::Document* const>(m_board->tree.steps)
                   : std::span<const model::Document* const>();
}

void PinModel::setBoard(const LoadedBoard& board) {
    beginResetModel();
    m_board = board.index;
    m_pinRanks = board.pinRanks;
    m_nets = board.nets;
    m_rows.clear();
    m_all.reset();
    m_areAllListed = false;
    endResetModel();
}

void PinModel::setPins(std::vector<BoardPin> pins) {
    setRows(rowsFor(std::move(pins)), false);
}

void PinModel::setAllPins() {
    if (m_areAllListed) {
        return;
    }
    if (!m_all) {
        std::vector<BoardPin> pins;
        for (std::uint32_t step = 0; step < steps().size(); ++step) {
            for (std::size_t row = 0; row < steps()[step]->pins.size(); ++row) {
                pins.push_back({step, model::PinId{row}});
            }
        }
        m_all = rowsFor(std::move(pins));
    }
    setRows(*m_all, true);
}

void PinModel::setRows(std::vector<Row> rows, bool areAll) {
    beginResetModel();
    m_rows = std::move(rows);
    m_areAllListed = areAll;
    endResetModel();
}

std::vector<PinModel::Row> PinModel::rowsFor(std::vector<BoardPin> pins) const {
    const auto rank = [&](const BoardPin& pin) {
        return pin.step < m_pinRanks.size() ? m_pinRanks[pin.step][pin.pin.row()]
                                            : static_cast<std::uint32_t>(pin.pin.row());
    };
    std::ranges::sort(pins, {}, [&](const BoardPin& pin) { return std::pair(pin.step, rank(pin)); });
    std::vector<Row> rows;
    rows.reserve(pins.size());
    std::ranges::transform(pins, std::back_inserter(rows), [&](const BoardPin& pin) { return rowFor(pin); });
    return rows;
}

PinModel::Row PinModel::rowFor(const BoardPin& pin) const {
    Row row{.pin = pin, .top = {}, .bottom = {}};
    const model::Document& step = stepOf(pin);
    for (const model::ElementId element : m_board->pins[pin.step].elementsOf(pin.pin)) {
        const model::LayerId id = step.elements.layer[element.row()];
        if (step.layer(id).isCopper()) {
            row.top = row.top.isValid() ? std::min(row.top, id) : id;
            row.bottom = row.bottom.isValid() ? std::max(row.bottom, id) : id;
        }
    }
    return row;
}

std::vector<int> PinModel::rowsOf(std::vector<BoardPin> pins) const {
    std::ranges::sort(pins);
    std::vector<int> rows;
    for (std::size_t row = 0; row < m_rows.size() && !pins.empty(); ++row) {
        if (std::ranges::binary_search(pins, m_rows[row].pin)) {
            rows.push_back(static_cast<int>(row));
        }
    }
    return rows;
}

std::optional<model::BoardNet> PinModel::netAt(int row) const {
    const model::NetId net = recordOf(row).net;
    return net.isValid() ? std::optional(model::BoardNet{pinAt(row).step, net}) : std::nullopt;
}

const model::Pin& PinModel::recordOf(int row) const {
    const BoardPin pin = pinAt(row);
    return stepOf(pin).pins[pin.pin.row()];
}

std::size_t PinModel::netRank(const BoardPin& pin) const {
    const std::size_t row = stepOf(pin).pins[pin.pin.row()].net.row();
    return pin.step < m_nets.size() ? m_nets[pin.step]->nameRank[row] : row;
}

Cell PinModel::layerCell(const Row& row) const {
    if (!row.top.isValid()) {
        return {.text = tr("no copper"), .order = place({})};
    }
    const model::Document& step = stepOf(row.pin);
    const QString top = QString::fromStdString(step.layer(row.top).name);
    const QString text =
        row.top == row.bottom ? top : tr("%1 to %2").arg(top, QString::fromStdString(step.layer(row.bottom).name));
    return {.text = text, .order = place(row.top.row() * step.layers.size() + row.bottom.row())};
}

Cell PinModel::cell(int row, int column) const {
    const BoardPin pin = pinAt(row);
    const model::Document& step = stepOf(pin);
    const model::Pin& record = recordOf(row);
    switch (column) {
        case Pin: return {.text = QString::fromStdString(model::fullPinName(step, pin.pin)), .order = row};
        case Net:
            return record.net.isValid() ? Cell{.text = netName(step, record.net), .order = place(netRank(pin))}
                                        : Cell{.text = QString(), .order = place({})};
        case Layer: return layerCell(m_rows[static_cast<std::size_t>(row)]);
        case X: return length(record.position.x);
        case Y: return length(record.position.y);
        default: return text(step.job.step);
    }
}

QString PinModel::tip(int row, int column) const {
    return column == Net || column == Layer ? cell(row, column).text.toString() : QString();
}

}  // namespace ui
