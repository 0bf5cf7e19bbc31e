# SPDX-License-Identifier: Apache-2.0
"""The regions of an evaluation in the code of a verilated model with clock domains, by Verilator's
own names of 5.006 and 5.48 (cosim/verilated/regions.hpp)."""

import re

FORM = """
// Of Verilator: the regions of an evaluation.
{declarations}
namespace trammel::cosim {{

template <>
struct Regions<{root}> {{
  using Root = {root};
  static constexpr bool kKnown = true;
  static constexpr std::size_t kDomains = {domains};
  static constexpr std::size_t kTriggers = {triggers};
  static void inputs(Root& root) {{
    {flag};
    {root}___eval_ico(&root);
  }}
  static auto& look(Root& root) {{
    {root}___{look}(&root);
    return root.__VactTriggered;
  }}
  static auto& move(Root& root) {{ return root.__VnbaTriggered; }}
  static void registers(Root& root) {{ {root}___eval_nba(&root); }}
{registers}}};

}}  // namespace trammel::cosim
"""

# Clocks that are known when it is compiled, so that nothing of the others is looked at.
REGISTERS = """  static constexpr bool kRegistersOf = true;
  template <unsigned kRisen>
  static void registers_of(Root& root) {{
{lines}
  }}
"""

LONG = 2000  # characters of a function that is worth a comparison
FEW = 3      # members that are compared for it

# Type of the flags, first one of the inputs, function of the clocks.
VERILATORS = (
    (r"VlTriggerVec<(\d+)>", "root.__VicoTriggered.at(0) = true", "eval_triggers__act"),
    (r"VlUnpacked<QData/\*63:0\*/, (\d+)>", "root.__VicoTriggered[0] |= 1",
     "eval_triggers_vec__act"))


def body(code, function, root):
    """Statements of a function of the model, or None."""
    found = re.search(rf"^(?:VL_INLINE_OPT )?void {function}\({root}\* vlSelf\) {{\n(.*?)^}}\n",
                      code, re.M | re.S)
    return found[1].split("// Body\n")[-1] if found else None


def risen(condition):
    """Mask of the triggers in a condition of 5.006 or 5.48, or None if it is anything else."""
    at = r"vlSelf->__VnbaTriggered\.at\((\w+?)U\)"
    if re.fullmatch(r"[\s()|]*", re.sub(at, "", condition)):
        return sum({1 << int(n, 0) for n in re.findall(at, condition)})
    of = re.fullmatch(r"\((\w+?)ULL & vlSelfRef\.__VnbaTriggered\[0U\]\)", condition)
    return int(of[1], 0) if of else None


def calls(code, root):
    """What the region of the registers calls: masks of triggers and functions, or None where it
    does anything else."""
    rest = body(code, f"{root}___eval_nba", root)
    found = []
    while rest and rest.strip():
        call = re.match(rf"\s*if \(([^{{}};]*)\) {{\s*({root}___\w+)\(vlSelf\);\s*}}", rest)
        mask = risen(call[1]) if call else None
        if not mask or "Triggered" in (body(code, call[2], root) or "Triggered"):
            return None
        found.append((mask, call[2]))
        rest = rest[call.end():]
    return found or None


def members_of(text, root):
    """Members that a function reads or writes, and those that it writes."""
    named = set(re.findall(r"vlSelf->(\w+)", text))
    if re.search(rf"\b(?:VL_ASSIGN\w*|(?!{root}\b)V\w*_\w*TOP\w*|{root}___\w+)\(", text):
        return named, named  # what it calls may write them
    return named, set(re.findall(r"vlSelf->(\w+)(?:\s*\[[^;{}]*?\])*\s*=(?!=)", text))


def guards(called, code, root, header, is_register):
    """Of the functions that hold no register: {function: {trigger: members}}, by which of its
    inputs alone a clock changes what it computes. As long as these keep their values it need not
    be called."""
    scalars = set(re.findall(r"(?:CData|SData|IData|QData)/\*[\d:]+\*/ (\w+);", header) +
                  re.findall(r"VL_(?:IN|OUT)(?:8|16|64)?\((\w+),", header))
    parts = {name: members_of(body(code, name, root), root) for _, name in called}
    found = {}
    for mask, name in called:
        named, own = parts[name]
        if len(body(code, name, root)) < LONG or any(map(is_register, own)):
            continue
        inputs = {}
        for trigger in range(max(m for m, _ in called).bit_length()):
            written = set().union(*(parts[other][1] for m, other in called
                                    if m >> trigger & 1 and other != name)) & named
            if written and not mask >> trigger & 1:
                inputs = {}
                break
            if mask >> trigger & 1 and 0 < len(written) <= FEW and written <= scalars:
                inputs[trigger] = sorted(written)
        if inputs:
            found[name] = inputs
    return found


def registers_of(called, guarded):
    """The lines of registers_of(): first the inputs that are compared, then the calls."""
    members = sorted({m for inputs in guarded.values() for some in inputs.values() for m in some})
    lines = [f"    [[maybe_unused]] const auto was_{n} = root.{member};"
             for n, member in enumerate(members)]
    for mask, name in called:
        call = f"{name}(&root);"
        inputs = guarded.get(name)
        if not inputs:
            lines.append(f"    if constexpr ((kRisen & {mask:#x}u) != 0) {call}")
            continue
        always = mask & ~sum(1 << trigger for trigger in inputs)
        lines += [f"    if constexpr ((kRisen & {always:#x}u) != 0) {{", f"      {call}",
                  f"    }} else if constexpr ((kRisen & {mask:#x}u) != 0) {{", "      if ("]
        tests = [f"(kRisen & {1 << trigger:#x}u) != 0 && "
                 f"root.{member} != was_{members.index(member)}"
                 for trigger, some in inputs.items() for member in some]
        lines[-1] += f"({') || ('.join(tests)})) {call}"
        lines.append("    }")
    return "\n".join(lines)


def regions(path, is_register):
    """Specialisation of Regions for a model with clock domains, if its Verilator is known.
    is_register(member) tells what a clock alone may change."""
    root = path.stem
    header = path.read_text(encoding="utf-8")
    domains = re.search(r"VL_IN(?:8|16)?\(clock_en_i,(\d+),0\)", header)
    code = "".join(f.read_text(encoding="utf-8") for f in sorted(path.parent.glob("*.cpp")))
    for kind, flag, look in VERILATORS:
        found = [re.search(rf"{kind} __V{name}Triggered;", header)
                 for name in ("ico", "act", "nba")]
        names = [f"{root}___{call}" for call in (look, "eval_ico", "eval_nba")]
        if not (domains and all(found) and all(body(code, name, root) for name in names)):
            continue
        clocks = dict(re.findall(r"index (\d+) is active: @\((.*)\)", code))
        if not all(clock.startswith("posedge ") for clock in clocks.values()):
            return ""  # a loop of combinational logic takes more than one pass
        called = calls(code, root) or []
        registers = REGISTERS.format(lines=registers_of(
            called, guards(called, code, root, header, is_register))) if called else ""
        names += sorted({name for _, name in called})
        return FORM.format(root=root, domains=int(domains[1]) + 1, triggers=len(clocks), flag=flag,
                           look=look, registers=registers, declarations="\n".join(
                               f"void {name}({root}* root);" for name in names))
    return ""
