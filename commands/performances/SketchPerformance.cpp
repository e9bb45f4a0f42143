// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DrawSketch.h"
#include "commands/recipe/SketchOperation.h"

namespace espalier {

QString SketchOperation::perform(TreeDocument& document) const
{
    const Result<void> drawn = drawSketch(document, sketch);
    return drawn ? QString() : drawn.error().message;
}

} // namespace espalier
