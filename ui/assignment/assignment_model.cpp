#include "ui/assignment/assignment_model.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace ui {

namespace {

using model::LayerSide;
using model::gerber::FileRole;
using model::gerber::LayerProposal;
using Kind = FileRole::Kind;

/// What a file may draw, as it is chosen.
struct Choice {
    Kind kind;
    bool isNegative;
    const char* text;
};
constexpr Choice kChoices[] = {
    {Kind::Copper, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Copper")},
    {Kind::Copper, true, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Copper, negative")},
    {Kind::SolderMask, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Solder mask")},
    {Kind::Paste, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Solder paste")},
    {Kind::Legend, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Silkscreen")},
    {Kind::Profile, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Outline")},
    {Kind::Drill, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Drilled holes")},
    {Kind::Rout, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Routed slots")},
    {Kind::Components, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Components")},
    {Kind::Glue, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Glue")},
    {Kind::Document, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Drawing")},
    {Kind::Ignored, false, QT_TRANSLATE_NOOP("ui::AssignmentModel", "Left out")},
};

QString textOf(const Choice& choice) {
    return AssignmentModel::tr(choice.text);
}

QString leftOut() {
    return textOf(*std::rbegin(kChoices));
}

QString topText() {
    return AssignmentModel::tr("Top");
}
QString innerText() {
    return AssignmentModel::tr("Inner");
}
QString bottomText() {
    return AssignmentModel::tr("Bottom");
}

QString textOf(LayerSide side) {
    switch (side) {
        case LayerSide::Top: return topText();
        case LayerSide::Inner: return innerText();
        case LayerSide::Bottom: return bottomText();
        default: return {};
    }
}

bool isDrilled(const FileRole& role) {
    return role.kind == Kind::Drill || role.kind == Kind::Rout;
}

bool isSided(const FileRole& role) {
    return role.kind == Kind::Copper || role.kind == Kind::SolderMask || role.kind == Kind::Paste ||
           role.kind == Kind::Legend || role.kind == Kind::Components || role.kind == Kind::Glue;
}

bool isUnknown(const LayerProposal& proposal) {
    return proposal.isImage() && !proposal.role.isKnown();
}

/// "image" of what draws something that is not known.
QString drawsText(const LayerProposal& proposal) {
    if (proposal.role.kind == Kind::Ignored) {
        return leftOut();
    }
    if (!proposal.isImage()) {
        return AssignmentModel::tr("Nothing: %1").arg(QString::fromStdString(proposal.content));
    }
    const auto choice = std::ranges::find_if(kChoices, [&](const Choice& c) {
        return c.kind == proposal.role.kind && c.isNegative == (c.kind == Kind::Copper && proposal.role.isNegative);
    });
    return choice == std::end(kChoices) ? AssignmentModel::tr("Not known") : textOf(*choice);
}

QStringList drawsChoices(const LayerProposal& proposal) {
    QStringList texts;
    if (!proposal.isImage()) {
        LayerProposal used = proposal;
        used.role.kind = Kind::Unknown;
        return {drawsText(used), leftOut()};
    }
    if (isUnknown(proposal)) {
        texts += drawsText(proposal);
    }
    std::ranges::transform(kChoices, std::back_inserter(texts), [](const Choice& choice) { return textOf(choice); });
    return texts;
}

QStringList platedChoices() {
    return {AssignmentModel::tr("Not said"), AssignmentModel::tr("Plated"), AssignmentModel::tr("Not plated")};
}

QString platedText(model::Plating plating) {
    const QStringList choices = platedChoices();
    return plating == model::Plating::NotSaid     ? choices[0]
           : plating == model::Plating::NonPlated ? choices[2]
                                                  : choices[1];
}

}  // namespace

AssignmentModel::AssignmentModel(QObject* parent)
    : TableModel(
          {{tr("File"), tr("Inside the job")},
           {tr("Board"), tr("Of the several boards of the job; empty if the file belongs to all")},
           {tr("Draws"), tr("What the file draws"), kEditable},
           {tr("Side"), tr("Where the layer lies"), kEditable},
           {tr("Layer"), tr("Number of the copper layer, from the top; another number moves the layer there"),
            kEditable | kNumber},
           {tr("Plated"), tr("Are the holes plated?"), kEditable},
           {tr("Through"), tr("First and last copper layer that the holes pass, \"1-4\"; empty: all"), kEditable},
           {tr("Known by"), tr("What tells what the file draws")}},
          parent) {}

void AssignmentModel::setProposals(std::vector<Proposal> proposals) {
    beginResetModel();
    m_proposals = std::move(proposals);
    m_listed.clear();
    for (std::size_t row = 0; row < m_proposals.size(); ++row) {
        if (m_proposals[row].content != "other" || m_proposals[row].role.kind == Kind::Ignored) {
            m_listed.push_back(row);
        }
    }
    // What nobody knows is looked at first.
    std::ranges::stable_partition(m_listed, [this](std::size_t row) { return isUnknown(m_proposals[row]); });
    endResetModel();
}

bool AssignmentModel::hasBoards() const {
    return std::ranges::any_of(m_proposals, [](const Proposal& proposal) { return !proposal.board.empty(); });
}

bool AssignmentModel::drawsAnything() const {
    return std::ranges::any_of(m_proposals, [](const Proposal& proposal) {
        return proposal.isImage() && proposal.role.kind != Kind::Ignored;
    });
}

int AssignmentModel::firstUnknown() const {
    const auto found = std::ranges::find_if(m_listed, [this](std::size_t row) { return isUnknown(m_proposals[row]); });
    return found == m_listed.end() ? -1 : static_cast<int>(found - m_listed.begin());
}

std::size_t AssignmentModel::copperCount(const std::string& board) const {
    return static_cast<std::size_t>(std::ranges::count_if(m_proposals, [&](const Proposal& proposal) {
        return proposal.role.kind == Kind::Copper && proposal.board == board;
    }));
}

QStringList AssignmentModel::sidesOf(const Proposal& proposal) const {
    const bool hasInner = proposal.role.kind == Kind::Copper && copperCount(proposal.board) > 2;
    return hasInner ? QStringList{topText(), innerText(), bottomText()} : QStringList{topText(), bottomText()};
}

bool AssignmentModel::isMeant(int row, int column) const {
    const FileRole& role = at(row).role;
    switch (column) {
        case Draws: return true;
        case Side: return isSided(role);
        case Number: return role.kind == Kind::Copper;
        case Plated:
        case Span: return isDrilled(role);
        default: return false;
    }
}

Qt::ItemFlags AssignmentModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags all = TableModel::flags(index);
    return index.isValid() && !isMeant(index.row(), index.column()) ? all & ~Qt::ItemFlags(Qt::ItemIsEditable) : all;
}

Cell AssignmentModel::cell(int row, int column) const {
    const Proposal& proposal = at(row);
    const FileRole& role = proposal.role;
    switch (column) {
        case File: return text(proposal.path);
        case Board: return text(proposal.board);
        case Draws: {
            Cell cell{.text = drawsText(proposal), .choices = drawsChoices(proposal)};
            if (isUnknown(proposal)) {
                cell.font = boldFont();
            }
            return cell;
        }
        case Side:
            return {.text = textOf(role.side), .choices = isMeant(row, column) ? sidesOf(proposal) : QStringList()};
        case Number: return role.kind == Kind::Copper && role.order > 0 ? Cell{.text = role.order} : Cell{};
        case Plated:
            return isMeant(row, column) ? Cell{.text = platedText(role.plating), .choices = platedChoices()} : Cell{};
        case Span:
            return role.spanTop > 0 ? Cell{.text = QStringLiteral("%1-%2").arg(role.spanTop).arg(role.spanBottom)}
                                    : Cell{};
        default: {
            const QString why = QString::fromStdString(proposal.why);
            return {.text = proposal.isSure ? why : tr("not sure: %1").arg(why)};
        }
    }
}

QString AssignmentModel::tip(int row, int column) const {
    return column == File || column == KnownBy ? cell(row, column).text.toString() : QString();
}

bool AssignmentModel::edit(int row, int column, const QVariant& value) {
    if (!isMeant(row, column)) {
        return false;
    }
    Proposal& proposal = m_proposals[m_listed[static_cast<std::size_t>(row)]];
    const QString text = value.toString().trimmed();
    if (text == cell(row, column).text.toString()) {
        return true;
    }
    const bool isDone = column == Draws    ? setDraws(proposal, text)
                        : column == Side   ? setSide(proposal, text)
                        : column == Number ? setNumber(proposal, text)
                        : column == Plated ? setPlated(proposal, text)
                                           : setSpan(proposal, text);
    if (isDone) {
        proposal.why = tr("changed here").toStdString();
        proposal.isSure = true;
        announceChange();
        emit edited();
    }
    return isDone;
}

std::vector<AssignmentModel::Proposal*> AssignmentModel::copperOf(const std::string& board) {
    std::vector<Proposal*> copper;
    for (Proposal& proposal : m_proposals) {
        if (proposal.role.kind == Kind::Copper && proposal.board == board) {
            copper.push_back(&proposal);
        }
    }
    std::ranges::stable_sort(copper, {}, [](const Proposal* proposal) { return proposal->role.order; });
    return copper;
}

void AssignmentModel::renumber(const std::vector<Proposal*>& copper) {
    for (std::size_t place = 0; place < copper.size(); ++place) {
        FileRole& role = copper[place]->role;
        role.order = static_cast<int>(place) + 1;
        role.isCountedFromTop = true;
        if (copper.size() > 1 || role.side == LayerSide::Inner || role.side == LayerSide::None) {
            role.side = place == 0 ? LayerSide::Top : place + 1 == copper.size() ? LayerSide::Bottom : LayerSide::Inner;
        }
    }
}

void AssignmentModel::moveCopper(Proposal& moved, std::size_t place) {
    std::vector<Proposal*> copper = copperOf(moved.board);
    std::erase(copper, &moved);
    place = std::min(place, copper.size());
    copper.insert(copper.begin() + static_cast<std::ptrdiff_t>(place), &moved);
    renumber(copper);
}

bool AssignmentModel::setDraws(Proposal& proposal, const QString& text) {
    FileRole role;
    const auto choice = std::ranges::find_if(kChoices, [&](const Choice& c) { return textOf(c) == text; });
    const bool isUsed = text != leftOut();
    if (proposal.isImage() ? choice == std::end(kChoices) : isUsed && text != drawsChoices(proposal).front()) {
        emit refused(tr("Files do not draw \"%1\"; choose from the list").arg(text));
        return false;
    }
    role.kind = proposal.isImage() ? choice->kind : isUsed ? Kind::Unknown : Kind::Ignored;
    role.isNegative = proposal.isImage() && choice->isNegative;
    if (role.kind == Kind::Copper && proposal.role.kind == Kind::Copper) {
        proposal.role.isNegative = role.isNegative;
        return true;
    }
    const bool isBottom = proposal.role.side == LayerSide::Bottom;
    role.side = isDrilled(role) ? LayerSide::Through
                : isSided(role) ? (isBottom ? LayerSide::Bottom : LayerSide::Top)
                                : LayerSide::None;
    if (isDrilled(role) && isDrilled(proposal.role)) {
        role.plating = proposal.role.plating;
        role.spanTop = proposal.role.spanTop;
        role.spanBottom = proposal.role.spanBottom;
    }
    proposal.role = role;
    // Between top and bottom where there are both, else below what is there.
    const std::size_t others = copperCount(proposal.board) - (role.kind == Kind::Copper ? 1U : 0U);
    role.kind == Kind::Copper ? moveCopper(proposal, others > 1 ? others - 1 : others)
                              : renumber(copperOf(proposal.board));
    return true;
}

bool AssignmentModel::setSide(Proposal& proposal, const QString& text) {
    if (!sidesOf(proposal).contains(text)) {
        emit refused(tr("There is no side \"%1\" here").arg(text));
        return false;
    }
    const LayerSide side = text == topText()      ? LayerSide::Top
                           : text == bottomText() ? LayerSide::Bottom
                                                  : LayerSide::Inner;
    const std::size_t copper = copperCount(proposal.board);
    if (proposal.role.kind != Kind::Copper || copper == 1) {
        proposal.role.side = side;
        return true;
    }
    const bool wasTop = proposal.role.side == LayerSide::Top;
    moveCopper(proposal, side == LayerSide::Top ? 0 : side == LayerSide::Bottom ? copper - 1 : wasTop ? 1 : copper - 2);
    return true;
}

bool AssignmentModel::setNumber(Proposal& proposal, const QString& text) {
    bool isNumber = false;
    const int number = text.toInt(&isNumber);
    const auto most = static_cast<int>(copperCount(proposal.board));
    if (!isNumber || number < 1 || number > most) {
        emit refused(tr("Copper layers are numbered from 1 to %1").arg(most));
        return false;
    }
    moveCopper(proposal, static_cast<std::size_t>(number - 1));
    return true;
}

bool AssignmentModel::setPlated(Proposal& proposal, const QString& text) {
    const qsizetype row = platedChoices().indexOf(text);
    constexpr model::Plating kPlatings[] = {model::Plating::NotSaid, model::Plating::Plated, model::Plating::NonPlated};
    if (row < 0) {
        emit refused(tr("Holes are plated, not plated, or it is not said"));
        return false;
    }
    proposal.role.plating = kPlatings[row];
    return true;
}

bool AssignmentModel::setSpan(Proposal& proposal, const QString& text) {
    const auto role = model::gerber::roleOfWords("drill " + text.toStdString());
    const bool isSpan = role && role->plating == model::Plating::NotSaid && (text.isEmpty() || role->spanTop > 0);
    const auto most = static_cast<int>(copperCount(proposal.board));
    if (!isSpan || role->spanBottom > most) {
        emit refused(
            tr("Name the first and last copper layer, between 1 and %1, as 1-%1; nothing means all").arg(most));
        return false;
    }
    proposal.role.spanTop = role->spanTop;
    proposal.role.spanBottom = role->spanBottom;
    return true;
}

}  // namespace ui
