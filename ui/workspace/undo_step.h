#pragma once

#include <QUndoCommand>
#include <functional>
#include <utility>

namespace ui {

/// A step of the undo history that holds what is edited whole, before and after: for short lists, where undoing then
/// cannot miss anything.
template <class State>
class UndoStep : public QUndoCommand {
public:
    using Apply = std::function<void(const State&)>;

    UndoStep(const QString& what, State before, State after, Apply apply)
        : QUndoCommand(what), m_before(std::move(before)), m_after(std::move(after)), m_apply(std::move(apply)) {}

    void undo() override { m_apply(m_before); }
    void redo() override { m_apply(m_after); }

private:
    State m_before;
    State m_after;
    Apply m_apply;
};

}  // namespace ui
