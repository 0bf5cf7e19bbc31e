; Program of motion/lm628_engine, first part: the sample of the LM628 (data sheet SNVS781C, AN-693).
; scripts/tool gen-lm628 makes rtl/pkg/lm628_code_pkg.sv from it and lm628_engine_*.asm; the
; operations are those of rtl/pkg/lm628_pkg.sv. `if c l` goes to l if c holds, `ifn` if not; c is n,
; z, wrap, take, bit<k> of the accumulator, or a flag. One level of call.

; Cleared by a reset, in this order.
.zero pos speed target acc vel actual count velocity
.zero goal least acc_buf vel_buf pos_buf kp ki kd il every kp_buf ki_buf kd_buf il_buf every_buf
.zero sum last_e deriv wait break index control
.var  threshold one k15 k16 low16 k23
.var  t u e rest rest2 v w p f slow limit clipped delta

; ---- entries: a command starts at the address of its opcode ----
.at 0x00
        jmp boot
        jmp stt
        jmp dfh
        jmp sip
        jmp udf
        jmp port8
        jmp port12
        jmp rddv
        jmp rddp
        jmp rdip
        jmp rdrp
        jmp rdrv
        jmp rdsigs
        jmp rdsum
.at 0x1a
        jmp lpes
        jmp lpei
        halt                    ; MSKI and RSTI concern the host port alone
        halt
        jmp lfil
        jmp ltrj
        jmp sbpa
        jmp sbpr

; ---- the sample ----
.at 0x22
sample: in count                ; encoder: 24 bits, its difference moves the actual position
        st t
        sub count
        ext s24
        st velocity
        add actual
        ext s32
        st u
        ld t
        st count
        ifn filter s_index
        ld kp_buf               ; UDF: copy the filter; the command has cleared wait
        st kp
        ld kd_buf
        st kd
        ld il_buf
        st il
        ld every_buf
        st every
        ld ki_buf
        st ki
        clr filter
        ifn z s_index
        st sum
s_index:
        ifn take s_wrap
        in index
        sub count
        ext s24
        add u
        ext s32
        st index
        clr index_armed
        set index
s_wrap: ld actual               ; wraparound: the reported position does not move by the velocity
        ext s31
        add velocity
        st t
        ld u
        ext s31
        sub t
        if z s_moved
        set wraparound
s_moved:
        ld u
        st actual
        ifn off g_on
        shl 16                  ; off: the desired position follows the actual one
        st pos
        num 0
        st speed
        jmp s_error
g_on:   ifn moving s_error
        if smooth g_smooth
        if velocity g_velocity

; ---- generator, position mode ----
        ld goal
        sub pos
        st rest
        clr up
        if z g_there
        if n g_down
        set up
g_down: ld speed
        ifn z g_way
        ld acc
        if z g_hold
        ld vel
        ifn z g_way
g_hold: ld pos                  ; rule 0: no speed and no means to gain any
        shr8
        shr8
        st target
        shl 16
        st goal
        jmp g_done
g_there:
        ld speed
        if z g_done
        if n g_way
        set up
g_way:  if up g_plus            ; from here on rest and v are toward the target
        num 0
        sub rest
        st rest
        num 0
        sub speed
        jmp g_v
g_plus: ld speed
g_v:    st v
        ifn n g_toward
        add acc                 ; rule 1: it moves away
        if n g_set
        num 0
        jmp g_set
g_toward:
        sub acc
        ifn n g_slow
        num 0
g_slow: st slow
        ld rest
        if z g_rule3
        ld least
        sub rest
        if n g_rule3
        ld acc
        add acc
        sub v
        if n g_rule3
        ld rest                 ; rule 2: the last step
        jmp g_set
g_rule3:
        ld rest
        add rest
        st rest2
        ld vel
        sub v
        ifn n g_rule4
        ld v                    ; rule 3: above the limit
        sub acc
        st w
        sub vel
        ifn n g_fits3
        ld vel
        st w
g_fits3:
        call fits
        if n g_slower
        ld w
        jmp g_set
g_slower:
        ld slow
        jmp g_set
g_rule4:
        ld v                    ; rule 4: faster, as fast, slower
        add acc
        st w
        sub vel
        if n g_fits4
        ld vel
        st w
g_fits4:
        call fits
        ifn n g_found
        st f                    ; v fits if f + 2 n d + 2 min(d, p) >= 0, d = w - v
        ld w
        sub v
        st delta
        sub p
        if n g_least
        ld p
        jmp g_min
g_least:
        ld delta
g_min:  st t
        num 0
        mul delta 30
        add t
        shl 1
        add f
        if n g_rule4s
        ld v
        jmp g_set
g_rule4s:
        ld slow
        jmp g_set
g_found:                        ; not 0 short of the target: rule 2 has taken such cases
        ld w
g_set:  st w
        if up g_move
        num 0
        sub w
g_move: st speed
        add pos
        ext s48
        st pos
        sub goal
        ifn z s_error
        ld acc
        add acc
        sub w
        if n s_error
        num 0
        st speed
g_done: clr moving
        set on_target
        set complete

; ---- error, breakpoint ----
s_error:
        ld pos
        shr8
        shr8
        sub actual
        st e
        sub k15
        if n e_low
        ld k15
        st e
        jmp s_break
e_low:  add k16
        ifn n s_break
        ld low16
        st e
s_break:
        ifn armed s_check
        ld actual
        sub break
        ifn above b_below
        if n s_check
        jmp b_fire
b_below:
        ifn below b_fire
        if n b_fire
        ifn z s_check
b_fire: clr armed
        set breakpoint
s_check:
        if off f_off
        ld e
        ifn n e_above
        num 0
        sub e
e_above:
        sub threshold
        if n f_on
        if z f_on
        set position_error
        ifn off_on_error f_on
        call turn_off
f_off:  num 0
        st sum
        st last_e
        st deriv
        st wait
        out
        halt

; ---- filter ----
f_on:   ld k23
        st limit
        ld sum
        add e
        call clip
        st sum
        shr8
        st t
        ld il
        st limit
        ld ki
        toq15
        mul t 15
        call clip
        st u
        ld k15
        st limit
        ld wait
        if z f_deriv
        sub one
        st wait
        jmp f_prop
f_deriv:
        ld every
        st wait
        ld e
        sub last_e
        st t
        ld e
        st last_e
        ld kd
        toq15
        mul t 15
        call word
        st deriv
f_prop: ld kp
        toq15
        mul e 15
        call word
        add u
        add deriv
        call word
        out
        halt
