#pragma once

#include <vector>

#include "model/formats/gerber/layer_proposals.h"
#include "ui/common/table_model.h"

namespace ui {

/// What the files of a Gerber job draw, to look at and to change. Copper layers of a board are always numbered from 1
/// without holes: another number moves a layer there, and the first and the last are top and bottom. Files that draw
/// nothing (netlists, job files) can only be left out; those of no known content are not listed.
class AssignmentModel : public TableModel {
    Q_OBJECT

public:
    enum Column { File, Board, Draws, Side, Number, Plated, Span, KnownBy };

    explicit AssignmentModel(QObject* parent = nullptr);

    void setProposals(std::vector<model::gerber::LayerProposal> proposals);
    /// All files, also those that are not listed.
    [[nodiscard]] const std::vector<model::gerber::LayerProposal>& proposals() const { return m_proposals; }
    /// Does the job hold several boards?
    [[nodiscard]] bool hasBoards() const;
    /// Is anything left to draw?
    [[nodiscard]] bool drawsAnything() const;
    /// The first file of which nothing tells what it draws; -1 if there is none.
    [[nodiscard]] int firstUnknown() const;
    /// Cells that mean nothing for what the file draws cannot be edited.
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void edited();
    /// Why the last edit was refused.
    void refused(const QString& reason);

private:
    using Proposal = model::gerber::LayerProposal;

    [[nodiscard]] int rows() const override { return static_cast<int>(m_listed.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;

    [[nodiscard]] const Proposal& at(int row) const { return m_proposals[m_listed[static_cast<std::size_t>(row)]]; }
    [[nodiscard]] std::vector<Proposal*> copperOf(const std::string& board);
    [[nodiscard]] bool isMeant(int row, int column) const;
    [[nodiscard]] QStringList sidesOf(const Proposal& proposal) const;
    [[nodiscard]] std::size_t copperCount(const std::string& board) const;
    bool setDraws(Proposal& proposal, const QString& text);
    bool setSide(Proposal& proposal, const QString& text);
    bool setNumber(Proposal& proposal, const QString& text);
    bool setPlated(Proposal& proposal, const QString& text);
    bool setSpan(Proposal& proposal, const QString& text);
    void moveCopper(Proposal& moved, std::size_t place);
    static void renumber(const std::vector<Proposal*>& copper);

    std::vector<Proposal> m_proposals;
    std::vector<std::size_t> m_listed;  ///< rows of m_proposals
};

}  // namespace ui
