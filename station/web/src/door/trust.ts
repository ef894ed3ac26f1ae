// Why a browser warns of this machine, and how it is taught not to.

import { h } from "../kit/dom";
import { type Me, ask } from "./ask";
import { frame } from "./frame";
import { t } from "../kit/language";

const fingerprint = (name: string, text: string): HTMLElement =>
  h(
    "p",
    { class: "fingerprint" },
    h("strong", {}, name),
    h("code", {}, ...text.split(":").flatMap((octet, i) => (i === 0 ? [octet] : [":", h("wbr"), octet]))),
  );

const ways: [string, string][] = [
  ["Windows", t("open the file, Install Certificate, Local Machine, into Trusted Root Certification Authorities")],
  [
    "iPad, iPhone",
    t("open the file, then Settings, Profile Downloaded, Install; then General, About, Certificate Trust Settings: on"),
  ],
  ["Android", t("Settings, Security, Install a certificate, CA certificate, and choose the file")],
  ["Firefox", t("Settings, Certificates, View Certificates, Authorities, Import, for websites")],
  [
    "Linux",
    t("into /usr/local/share/ca-certificates, then update-ca-certificates; Chromium: Settings, Certificates, Import"),
  ],
];

export async function makeTrust(): Promise<void> {
  const root = frame(t("Is this the right machine?"));
  const me = await ask<Me>("me");
  const text = h("div", { class: "narrow text" });
  text.append(
    h(
      "p",
      {},
      t(
        "The instructor's screen and the program's start show the same fingerprint. " +
          "If yours is another one, somebody stands between: do not go on.",
      ),
    ),
    fingerprint(t("This machine's certificate, SHA-256"), me.fingerprint),
  );
  if (me.own_authority)
    text.append(
      fingerprint(t("Its authority, SHA-256"), me.authority_fingerprint),
      h(
        "p",
        {},
        t(
          "This machine has an authority of its own, which no browser knows: it warns until it is taught. " +
            "The authority can vouch for nothing but this machine's names and addresses in private networks.",
        ),
      ),
      h(
        "p",
        {},
        h(
          "a",
          { class: "button", href: "/authority.crt", download: "windlass-authority.crt" },
          t("Download the authority's certificate"),
        ),
      ),
      h("dl", {}, ...ways.flatMap(([system, way]) => [h("dt", {}, system), h("dd", {}, way)])),
    );
  else
    text.append(
      h(
        "p",
        {},
        t("This machine has a certificate of the house: a browser that knows the house's authority does not warn."),
      ),
    );
  text.append(h("p", { class: "ways" }, h("a", { href: "/" }, t("Back"))));
  root.append(text);
}
