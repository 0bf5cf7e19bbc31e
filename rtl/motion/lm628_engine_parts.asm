; Program of motion/lm628_engine, second part: the generator's other modes and the subroutines.

; ---- generator, velocity mode and smooth stop ----
g_smooth:
        num 0
        st t
        call ramp
        ifn z s_error
        ld pos
        shr8
        shr8
        st target
        shl 16
        st goal
        jmp g_done
g_velocity:
        ld vel
        if forward g_ramp
        num 0
        sub vel
g_ramp: st t
        call ramp
        jmp s_error

; ---- subroutines ----
ramp:   ld t                    ; speed toward t by at most acc; the accumulator ends with it
        sub speed
        st delta
        if n r_down
        sub acc
        if n r_step
        ld acc
        st delta
        jmp r_step
r_down: add acc
        ifn n r_step
        num 0
        sub acc
        st delta
r_step: ld speed
        add delta
        st speed
        add pos
        ext s48
        st pos
        ld speed
        ret

fits:   ld acc                  ; negative if w and the stopping distance exceed the rest:
        if z f_const            ; 2 rest - (n + 1)(w + p), n = w / acc with remainder p
        ld w
        toq
        div acc 30
        st p
        add w
        st t
        num 0
        mul t 30
        add t
        st t
        ld rest2
        sub t
        ret
f_const:
        ld rest
        sub w
        ret

word:   if wrap w_wrap          ; a product or sum in 16 bits
clip:   st clipped              ; to +-limit
        if n c_neg
        sub limit
        if n c_in
        ld limit
        ret
c_neg:  add limit
        ifn n c_in
        num 0
        sub limit
        ret
c_in:   ld clipped
        ret
w_wrap: ext s16
        ret

turn_off:
        if off t_was
        set complete
t_was:  set off
        clr moving
        ret

long:   in word                 ; two words, high one first
        shl 16
        st u
        in word
        add u
        ext s32
        ret
