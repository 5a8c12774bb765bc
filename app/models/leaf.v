angle increment: 45
initial line width: 0.4
initial color: 1
tropism direction: 0,1,0
material: 1 rachis kind=stem color=0.50,0.56,0.26 roughness=0.6
material: 2 leaflet kind=leaf color=0.24,0.44,0.15 roughness=0.45 translucency=0.45
organ: l leaflet kind=blade material=2 length=10.5 width=3.7 petiole=0.3 widest=0.42 tip=1.0 base=0.6 lobes=0.03 lobe_count=11 fold=16 curl=24
