// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/TwistOperation.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kTwistInternodeKey("internode");
constexpr QLatin1StringView kTwistAngleKey("angle");
constexpr QLatin1StringView kTwistScopeKey("scope");
constexpr QLatin1StringView kTwistBranch("branch");
constexpr QLatin1StringView kTwistSubtree("subtree");

} // namespace

TwistOperation TwistOperation::read(JsonReader& reader, RecipeReading&)
{
    TwistOperation twist{InternodeReference::read(reader, kTwistInternodeKey),
                         reader.number(kTwistAngleKey, -kMostAngle, kMostAngle)};
    const QString scope = reader.text(kTwistScopeKey, QString(kTwistBranch));
    if (scope == kTwistSubtree)
        twist.scope = TwistScope::Subtree;
    else if (scope != kTwistBranch)
        reader.fail(kTwistScopeKey,
                    RecipeText::tr("one of these is expected: %1").arg(QStringLiteral("branch, subtree")));
    return twist;
}

QJsonObject TwistOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kTwistInternodeKey, internode.toJson()}, {kTwistAngleKey, angle}};
    if (scope == TwistScope::Subtree)
        json[kTwistScopeKey] = QString(kTwistSubtree);
    return json;
}

} // namespace espalier
