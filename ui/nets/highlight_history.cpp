#include "ui/nets/highlight_history.h"

#include <QScopedValueRollback>
#include <functional>
#include <utility>

#include "ui/common/net_name.h"
#include "ui/workspace/step_ids.h"

namespace ui {

namespace {

using Nets = std::vector<model::BoardNet>;

QString textOf(const SelectionModel& selection, const Nets& nets) {
    if (nets.size() == 1) {
        const model::Document& step = *selection.tree().steps[nets.front().step];
        return HighlightHistory::tr("highlight of %1").arg(netName(step, nets.front().net));
    }
    return nets.empty() ? HighlightHistory::tr("end of highlights")
                        : HighlightHistory::tr("highlight of %L1 nets").arg(nets.size());
}

class HighlightStep : public QUndoCommand {
public:
    using Apply = std::function<void(const Nets&)>;

    HighlightStep(const QString& what, Nets before, Nets after, Apply apply)
        : QUndoCommand(what), m_before(std::move(before)), m_after(std::move(after)), m_apply(std::move(apply)) {}

    void undo() override { m_apply(m_before); }
    void redo() override { m_apply(m_after); }
    [[nodiscard]] int id() const override { return kHighlightStep; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* later = dynamic_cast<const HighlightStep*>(next);
        if (later == nullptr || !isStep() || !later->isStep()) {
            return false;
        }
        m_after = later->m_after;
        setText(later->text());
        return true;
    }

private:
    /// From one net to another.
    [[nodiscard]] bool isStep() const { return m_before.size() == 1 && m_after.size() == 1; }

    Nets m_before;
    Nets m_after;
    Apply m_apply;
};

}  // namespace

HighlightHistory::HighlightHistory(Workspace& workspace) : m_workspace(workspace) {
    connect(&workspace, &Workspace::boardRead, this, [this] { m_before.clear(); });
    connect(&workspace.selection(), &SelectionModel::netsChanged, this, &HighlightHistory::record);
}

void HighlightHistory::record() {
    const SelectionModel& selection = m_workspace.selection();
    Nets before = std::exchange(m_before, selection.nets());
    if (!m_isApplying && before != m_before) {
        m_workspace.history().push(new HighlightStep(textOf(selection, m_before), std::move(before), m_before,
                                                     [this](const Nets& nets) { apply(nets); }));
    }
}

void HighlightHistory::apply(const Nets& nets) {
    const QScopedValueRollback guard(m_isApplying, true);
    m_workspace.selection().setNets(nets);
}

}  // namespace ui
