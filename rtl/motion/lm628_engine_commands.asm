; Program of motion/lm628_engine, third part: the commands of the LM628 (data sheet SNVS781C,
; AN-693), and its reset.

boot:   num 0
.clear
        num 1
        st one
        shl 15
        sub one
        st k15
        st threshold
        shl 1
        add one
        st k16
        num 0
        sub one
        shl 15
        st low16
        num 1
        shl 23
        sub one
        st k23
        halt
sip:    set index_armed
        halt
udf:    set filter
        num 0
        st wait
        halt
port8:  set eight_bits
        halt
port12: clr eight_bits
        halt
rddv:   ld speed
        jmp give
rddp:   ld pos
        shr8
        shr8
        jmp place
rdip:   ld index
        jmp place
rdrp:   ld actual
place:  ext s31                 ; the data sheet's range of positions
        jmp give
rdrv:   ld velocity
        jmp give
rdsigs: in signals
        jmp give
rdsum:  ld sum
        shr8
give:   reply
        halt
lpes:   set off_on_error
        jmp lpe
lpei:   clr off_on_error
lpe:    in word
        ext z15
        st threshold
        halt

lfil:   in word
        st t
        shr8
        st every_buf
        ld t
        ifn bit3 l_ki
        in word
        ext z15
        st kp_buf
        ld t
l_ki:   ifn bit2 l_kd
        in word
        ext z15
        st ki_buf
        ld t
l_kd:   ifn bit1 l_il
        in word
        ext z15
        st kd_buf
        ld t
l_il:   ifn bit0 l_end
        in word
        ext z15
        st il_buf
l_end:  halt

ltrj:   in word
        st control
        ifn bit5 l_vel
        call long
        st t
        ld control
        ifn bit4 l_acc
        ld t
        add acc_buf
        jmp l_acc_new
l_acc:  ld t
l_acc_new:
        ext z30
        st acc_buf
        set acceleration
        ld control
l_vel:  ifn bit3 l_pos
        call long
        st t
        ld control
        ifn bit2 l_v
        ld t
        add vel_buf
        jmp l_vel_new
l_v:    ld t
l_vel_new:
        ext z30
        st vel_buf
        ld control
l_pos:  ifn bit1 l_end
        call long
        st pos_buf
        clr relative
        ld control
        ifn bit0 l_end
        set relative
        halt

sbpr:   call long
        st t
        ifn velocity_mode b_target
        ld pos
        shr8
        shr8
        jmp b_add
b_target:
        ld target
b_add:  add t
        ext s32
        jmp b_arm
sbpa:   call long
b_arm:  st break
        clr above
        clr below
        sub actual
        if z b_armed
        if n b_neg
        set above
        jmp b_armed
b_neg:  set below
b_armed:
        set armed
        halt

dfh:    ld actual
        shl 16
        st t
        ld pos
        sub t
        ext s48
        st pos
        ld target
        sub actual
        ext s32
        st target
        shl 16
        st goal
        ld break
        sub actual
        ext s32
        st break
        num 0
        st actual
        halt

stt:    ifn moving a_take
        ifn acceleration a_take
        ld control              ; in motion a new acceleration waits; only a stop is made without
        if bit8 a_place
        if bit9 a_place
        if bit10 a_place
        set error
        halt
a_take: ld acc_buf
        st acc
        clr acceleration
a_place:
        ld control
        if bit11 a_copy         ; velocity mode does not use the position
        ifn relative a_target
        ld target
        ifn velocity_mode a_sum
        ld pos
        shr8
        shr8
a_sum:  add pos_buf
        ext s32
        st pos_buf
        clr relative
a_target:
        ld pos_buf
        st target
a_copy: ld acc
        st least
        ld vel_buf
        st vel
        sub acc
        ifn n a_least
        ld vel
        st least
a_least:
        clr on_target
        clr smooth
        clr velocity
        clr velocity_mode
        clr forward
        ld control
        ifn bit12 a_mode
        set forward
a_mode: ifn bit11 a_stop
        set velocity_mode
        set velocity
a_stop: if bit8 a_off
        clr off
        set moving
        if bit9 a_abrupt
        ifn bit10 a_end
        set smooth
        jmp a_end
a_abrupt:
        clr velocity
        ld actual
        st target
        shl 16
        st pos
        num 0
        st speed
        jmp a_end
a_off:  call turn_off
a_end:  ld target
        shl 16
        st goal
        num 0                   ; bits 10 to 8 have been used
        ifn forward a_vel
        num 16
a_vel:  st t
        num 0
        ifn velocity_mode a_word
        num 8
a_word: add t
        shl 8
        st control
        halt
