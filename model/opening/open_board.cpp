#include "model/opening/open_board.h"

#include <utility>

#include "model/base/thickness_units.h"
#include "model/board/thickness_override.h"
#include "model/clearance/kicad_project_rules.h"
#include "model/formats/registry.h"

namespace model {

namespace {

using Thicknesses = std::vector<ThicknessOverride>;

base::Result<Thicknesses> parseThicknesses(const std::vector<std::string>& texts, const Stackup& stackup) {
    Thicknesses all;
    for (const std::string& text : texts) {
        const base::Result<ThicknessOverride> one = model::parseOverride(text, stackup);
        if (!one) {
            return base::Error{one.error().code, "--set-thickness: " + one.error().text};
        }
        session::setThickness(all, *one);
    }
    return all;
}

/// The board as its session and the request stack it.
base::Result<OpenedBoard> withSession(const OpenRequest& request, ReadBoard read) {
    session::LoadedSession found;
    std::optional<RuleFile> projectRules;
    if (!request.noSession) {
        found = session::loadSession(request.path, *read.document);
        projectRules = kicadRulesFor(request.path, *read.document);
    }
    const bool hasRules = projectRules && !projectRules->table.rules.empty();
    if (hasRules && !found.session.designRules) {  // the user has set none
        found.session.designRules = projectRules->table;
    }
    ASSIGN_OR_RETURN(Thicknesses once, parseThicknesses(request.thicknesses, read.document->stackup));
    OpenedBoard board{request, {}, {found.session.thicknesses, std::move(once)}};
    board.document = session::applyThicknesses(std::move(read.document), board.thicknesses.all());
    board.format = read.format->key;
    board.session = std::move(found.session);
    board.sessionFile = std::move(found.file);
    board.projectRules = std::move(projectRules);
    board.forms = std::move(read.forms);
    board.notes = std::move(found.ignored);
    return board;
}

}  // namespace

Thicknesses SetThicknesses::all() const {
    Thicknesses both = saved;
    for (const ThicknessOverride& change : once) {
        session::setThickness(both, change);
    }
    return both;
}

base::Result<OpenedBoard> openBoard(const OpenRequest& request, base::Progress& progress) {
    const ReadOptions options{request.step,     request.inferNets, request.format, request.member,
                              request.onlyAsks, request.layerMap,  request.limits};
    ASSIGN_OR_RETURN(ReadBoard read, readAnyBoard(request.path, options, progress));
    if (!read.document) {
        OpenedBoard asks{request, nullptr};
        asks.forms = std::move(read.forms);
        return asks;
    }
    const OpenRequest found = read.forms.empty() ? request : requestOf(request, read.forms.front());
    return withSession(found, std::move(read));
}

OpenRequest requestOf(OpenRequest request, const BoardForm& form) {
    request.path = form.path;
    request.member = form.member;
    request.format = form.format->key;
    request.onlyAsks = false;
    return request;
}

OpenRequest reloadRequest(const OpenedBoard& board) {
    OpenRequest request = board.request;
    request.thicknesses.clear();
    const std::vector<ThicknessOverride> set =
        request.noSession ? board.thicknesses.all() : board.thicknesses.once;  // else the file has them
    for (const ThicknessOverride& one : set) {
        request.thicknesses.push_back(one.layer + "=" + model::thicknessText(one.thickness));
    }
    return request;
}

}  // namespace model
