# path.svg: command, reference model and table; a square wave over time. error.svg: error to the
# model. Draws every `step`-th of the samples first..last of trace.csv.
over_time = path_kind eq 'square'
command = "lc rgb '#bbbbbb' lw 3"
model = "lc rgb '#1f77b4' lw 1.5"
stage = "lc rgb '#d62728' lw 1.5"
# t (ms); command, model and table (mm), x and y each
set table $d
plot 'trace.csv' every step::first::last using ((column('t_s') - from) * 1e3): \
  (column('x_command_m') * 1e3):(column('y_command_m') * 1e3): \
  (column('x_model_m') * 1e3):(column('y_model_m') * 1e3): \
  (column('x_position_m') * 1e3):(column('y_position_m') * 1e3) with table
unset table
set datafile separator whitespace
set datafile nocolumnheaders

set output 'path.svg'
if (over_time) {
  set terminal svg size 800,640 dynamic enhanced font 'Helvetica,13' background '#ffffff'
  set multiplot layout 2,1 title title
  set offsets 0, 0, graph 0.05, graph 0.05
  do for [axis=0:1] {
    name = axis == 0 ? 'X' : 'Y'
    set ylabel name . ' (mm)'
    if (axis == 1) { set xlabel 't (ms)' }
    plot $d using 1:(column(2 + axis)) with steps title name . ' command' @command, \
         $d using 1:(column(4 + axis)) with lines title 'model' @model, \
         $d using 1:(column(6 + axis)) with lines title 'table' @stage
  }
  unset multiplot
} else {
  set terminal svg size 800,760 dynamic enhanced font 'Helvetica,13' background '#ffffff'
  set title title
  set size ratio -1
  set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
  set xlabel 'x (mm)'
  set ylabel 'y (mm)'
  plot $d using 2:3 with lines title 'command' @command, \
       $d using 4:5 with lines title 'reference model' @model, \
       $d using 6:7 with lines title 'table' @stage
}

set size noratio
set terminal svg size 800,420 dynamic enhanced font 'Helvetica,13' background '#ffffff'
set output 'error.svg'
set title title
set xlabel 't (ms)'
set ylabel 'error to the model (mm)'
set offsets 0, 0, graph 0.05, graph 0.05
second = "lc rgb '#2ca02c' lw 1.5"
if (over_time) {
  plot $d using 1:($4-$6) with lines title 'x' @model, \
       $d using 1:($5-$7) with lines title 'y' @second
} else {
  plot $d using 1:($4-$6) with lines title 'x' @model, \
       $d using 1:($5-$7) with lines title 'y' @second, \
       $d using 1:(sqrt(($4-$6)**2+($5-$7)**2)) with lines title 'T(k)' @stage
}
