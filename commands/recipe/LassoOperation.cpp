// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/LassoOperation.h"

#include "commands/recipe/LassoJson.h"

namespace espalier {

LassoOperation LassoOperation::read(JsonReader& reader, RecipeReading& reading)
{
    LassoOperation lasso;
    lasso.only = BudReference::read(reader);
    lasso.steps = readSteps(reader);
    lasso.stroke = readLasso(reader, reading);
    return lasso;
}

QJsonObject LassoOperation::write(RecipeWriting&) const
{
    QJsonObject json = lassoToJson(stroke);
    only.write(json);
    writeSteps(json, steps);
    return json;
}

Box3 LassoOperation::reach() const
{
    Box3 box;
    box.extend(Vec3(Vec3::Zero()));
    for (const Vec2& point : stroke.points)
        box.extend(Vec3(stroke.origin + point.x() * stroke.right + point.y() * stroke.up));
    return box;
}

} // namespace espalier
