#include "ui/section/sections.h"

#include <QComboBox>
#include <QSaveFile>
#include <algorithm>
#include <utility>

#include "model/section/net_line.h"
#include "model/section/section_export.h"

namespace ui {

namespace {

/// The first corner of a line that is being drawn is none yet.
bool hasLength(const std::vector<base::PointD>& line) {
    return std::ranges::any_of(line, [&](base::PointD p) { return p.x != line.front().x || p.y != line.front().y; });
}

}  // namespace

Sections::Sections(BoardViews& views, SelectionModel& selection, const ActionSet& actions, QUndoStack& history,
                   QObject* parent)
    : QObject(parent),
      m_selection(selection),
      m_line(views.flat()),
      m_keeping(history),
      m_panel(new SectionPanel(selection, m_keeping.names(), actions)) {
    m_due.setSingleShot(true);
    m_due.setInterval(0);
    connect(&m_due, &QTimer::timeout, this, &Sections::cut);
    connect(&m_line, &SectionLine::moved, &m_due, qOverload<>(&QTimer::start));
    connect(&m_line, &SectionLine::finished, this, [this] {
        cut();
        emit placed();
    });
    connect(m_panel, &SectionPanel::cleared, this, [this] { cutAlong({}); });
    connect(m_panel, &SectionPanel::chosen, this, &Sections::goTo);
    connect(m_panel, &SectionPanel::forgotten, &m_keeping, &SavedSections::remove);
}

void Sections::setBoard(const LoadedBoard& board) {
    m_index = board.index;
    m_keeping.setBoard(board);
    m_line.setBoard({board.model->origin});
    m_panel->view().fit();
    cut();
}

void Sections::setHeights(std::shared_ptr<const model::Document> board) {
    if (m_index) {
        m_index = model::withHeights(*m_index, std::move(board));
        cut();
    }
}

void Sections::setColours(std::vector<QColor> colours) {
    m_colours = colours;
    m_panel->view().setColours(std::move(colours));
}

void Sections::draw(bool isOn) {
    m_line.setDrawing(isOn);
    if (isOn) {
        emit reported(
            QStringLiteral("Drag a line, or click its corners: a double click or Enter ends it, Backspace takes the "
                           "last corner back, Esc gives up"));
    }
}

bool Sections::giveUp() {
    const bool isDrawing = m_line.isDrawing();
    m_line.setDrawing(false);
    return isDrawing;
}

void Sections::cutAlong(std::vector<base::PointD> line) {
    m_line.setLine(std::move(line));
    m_panel->view().fit();
    cut();
}

void Sections::cut() {
    m_due.stop();
    if (m_index == nullptr || !hasLength(m_line.line())) {
        m_panel->view().setSection(nullptr, std::nullopt);
        m_panel->setRemarks({});
        return;
    }
    base::Result<model::Section> section = model::makeSection(*m_index, {m_line.line(), {}});
    if (!section) {
        m_panel->view().setSection(nullptr, std::nullopt);
        m_panel->setRemarks(QString::fromStdString(section.error().text));
        return;
    }
    QStringList notes;
    for (const std::string& note : section->notes) {
        notes += QString::fromStdString(note);
    }
    m_panel->setRemarks(notes.join('\n'));
    m_panel->view().setSection(m_index, std::move(*section));
}

std::optional<std::pair<base::PointD, base::PointD>> Sections::straightLine() const {
    if (m_line.line().size() != 2) {
        return std::nullopt;
    }
    return std::pair(m_line.line().front(), m_line.line().back());
}

void Sections::followNet() {
    if (m_index == nullptr || m_selection.nets().size() != 1) {
        emit reported(QStringLiteral("Highlight one net first: N over its copper, or a click in the Nets panel"));
        return;
    }
    const model::BoardNet& net = m_selection.nets().front();
    const auto copy = std::ranges::find(m_index->tree.copies, net.step, &model::StepCopy::step);
    const auto row = static_cast<std::uint32_t>(copy - m_index->tree.copies.begin());
    if (base::Result<std::vector<base::PointD>> line = model::lineAlong(*m_index, {row, net.net})) {
        cutAlong(std::move(*line));
        emit placed();
    } else {
        emit reported(QString::fromStdString(line.error().text));
    }
}

void Sections::keep() {
    const std::optional<model::Section>& section = m_panel->view().section();
    emit reported(section ? QStringLiteral("Kept as %1").arg(m_keeping.keep(section->line))
                          : QStringLiteral("There is no section to keep: draw one first"));
}

void Sections::goTo(int row) {
    const model::session::SavedSection& kept = m_keeping.sections()[static_cast<std::size_t>(row)];
    if (!m_keeping.isHere(kept)) {
        const auto& steps = m_index->board->job.steps;
        const bool isKnown = std::ranges::find(steps, kept.step) != steps.end();
        emit reported((isKnown ? QStringLiteral("%1 is a section of step %2, which is not open")
                               : QStringLiteral("%1 is a section of step %2, which this board does not have"))
                          .arg(QString::fromStdString(kept.name), QString::fromStdString(kept.step)));
        return;
    }
    cutAlong(kept.line);
    emit placed();
}

base::Status Sections::save(const QString& path) const {
    const std::optional<model::Section>& section = m_panel->view().section();
    if (!section) {
        return base::Error{base::ErrorCode::BadUsage, "There is no section to export: draw one first."};
    }
    model::SectionPicture how;
    for (const QColor& colour : m_colours) {
        how.colours.push_back(colour.rgb() & 0xffffffU);
    }
    how.heightTimes = m_panel->heightsBox().currentData().toDouble();
    QSaveFile file(path);
    const QByteArray svg = QByteArray::fromStdString(model::sectionSvg(*m_index->board, *section, how));
    if (!file.open(QIODevice::WriteOnly) || file.write(svg) != svg.size() || !file.commit()) {
        return base::Error{base::ErrorCode::OutputFailed,
                           (path + QStringLiteral(" cannot be written: ") + file.errorString()).toStdString()};
    }
    return base::Done{};
}

}  // namespace ui
